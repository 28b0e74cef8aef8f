#pragma once

#include <QDialog>

#include <string_view>
#include <vector>

class QCheckBox;

namespace fumage::ui {

/// Asks which groups of parameters of a layer on the clipboard others are to have.
class PasteDialog : public QDialog {
    Q_OBJECT

public:
    /// @param from   name of the layer on the clipboard
    /// @param to     what the layers are called that get its parameters
    /// @param ticked groups that are chosen at first
    PasteDialog(const QString& from, const QString& to, const std::vector<std::string_view>& ticked, QWidget* parent);

    /// Those that are chosen, in the order of the panel.
    [[nodiscard]] std::vector<std::string_view> groups() const;

private:
    void tick(bool all);

    std::vector<QCheckBox*> m_boxes; ///< one a group, in their order
};

} // namespace fumage::ui
