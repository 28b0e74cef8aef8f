#pragma once

#include <QObject>

class QMainWindow;
class QSpinBox;
class QWidget;

namespace fumage::ui {

/// The main window that a widget belongs to, be it in a panel that floats; null in a dialog.
[[nodiscard]] QMainWindow* mainWindowOf(const QWidget& widget);

/// Hands the keyboard from a field to what its window is about, the centre of a main window: what was typed is done,
/// and keys are shortcuts again. In a dialog the field keeps it.
void leaveField(QWidget& field);

/// Whether a main window is around a widget, and no dialog.
[[nodiscard]] bool isInMainWindow(const QWidget& widget);

/// Return takes over what was typed into a spin box, Escape what was there before, and both leave it.
class SpinBoxKeys : public QObject {
    Q_OBJECT

public:
    /// @param box owns it
    explicit SpinBoxKeys(QSpinBox& box);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QSpinBox& m_box;
};

} // namespace fumage::ui
