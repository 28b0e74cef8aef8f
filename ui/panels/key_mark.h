#pragma once

#include "ui/document/key_edits.h"

#include <QAbstractButton>

namespace fumage::ui {

/// The diamond beside a parameter: hollow and faint where it does not change over time, an outline where it does,
/// filled where it has a key frame at the time that is shown. A click puts one there or takes it away.
class KeyMark : public QAbstractButton {
    Q_OBJECT

public:
    KeyMark(const Parameter& parameter, Document& document, QWidget* parent);

    void sync();
    [[nodiscard]] KeyState state() const { return m_state; }
    QSize sizeHint() const override { return {kWidth, kWidth}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    static constexpr int kWidth = 16; ///< pixels
    void toggle();

    const Parameter& m_parameter;
    Document& m_document;
    KeyState m_state = KeyState::None;
};

} // namespace fumage::ui
