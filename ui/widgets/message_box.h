#pragma once

#include <QMessageBox>

namespace fumage::ui {

/// A message box that shows its texts as they are; see plainToolTip(). No other is used.
class MessageBox : public QMessageBox {
    Q_OBJECT

public:
    /// @param name objectName
    MessageBox(const QString& name, Icon icon, const QString& title, const QString& text, StandardButtons buttons,
        QWidget* parent);

    /// Puts more text under the first.
    void explain(const QString& text);

    /// Says what went wrong and waits for OK.
    static void warn(QWidget* parent, const QString& title, const QString& text);
    /// @return whether the answer is yes
    [[nodiscard]] static bool ask(QWidget* parent, const QString& title, const QString& text);
};

} // namespace fumage::ui
