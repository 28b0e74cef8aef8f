#pragma once

#include <QSpinBox>

#include <optional>

namespace fumage::ui {

/// A spin box that reads what is typed as the fields of the panels do: thousands may be parted, and it calculates.
class WholeBox : public QSpinBox {
    Q_OBJECT

public:
    using QSpinBox::QSpinBox;

protected:
    int valueFromText(const QString& text) const override;
    QString textFromValue(int value) const override;
    QValidator::State validate(QString& text, int& cursor) const override;
    /// Leaves alone what is no number: QSpinBox would take out all signs between digits, and read another one.
    void fixup(QString& /*text*/) const override { }

private:
    /// Without what stands before and behind the number. @return nothing where it is none
    [[nodiscard]] std::optional<int> read(const QString& text) const;
};

} // namespace fumage::ui
