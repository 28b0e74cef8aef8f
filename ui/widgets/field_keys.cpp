#include "ui/widgets/field_keys.h"

#include <QDialog>
#include <QKeyEvent>
#include <QMainWindow>
#include <QSpinBox>

namespace fumage::ui {

QMainWindow* mainWindowOf(const QWidget& widget)
{
    for (QWidget* around = widget.parentWidget(); around != nullptr; around = around->parentWidget()) {
        if (qobject_cast<QDialog*>(around) != nullptr) {
            return nullptr;
        }
        if (auto* window = qobject_cast<QMainWindow*>(around)) {
            return window;
        }
    }
    return nullptr;
}

bool isInMainWindow(const QWidget& widget)
{
    return mainWindowOf(widget) != nullptr;
}

void leaveField(QWidget& field)
{
    if (QMainWindow* window = mainWindowOf(field)) {
        window->activateWindow(); // a panel that floats is a window of its own
        window->centralWidget()->setFocus(Qt::OtherFocusReason);
    }
}

SpinBoxKeys::SpinBoxKeys(QSpinBox& box)
    : QObject(&box)
    , m_box(box)
{
    box.installEventFilter(this);
}

bool SpinBoxKeys::eventFilter(QObject* watched, QEvent* event)
{
    const int key = event->type() == QEvent::KeyPress ? static_cast<const QKeyEvent&>(*event).key() : 0;
    switch (key) {
    case Qt::Key_Escape:
        m_box.setValue(m_box.value()); // puts its text back
        leaveField(m_box);
        return isInMainWindow(m_box);
    case Qt::Key_Return:
    case Qt::Key_Enter:
        m_box.interpretText();
        leaveField(m_box);
        return true;
    default: return QObject::eventFilter(watched, event);
    }
}

} // namespace fumage::ui
