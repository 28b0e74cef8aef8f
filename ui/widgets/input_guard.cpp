#include "ui/widgets/input_guard.h"

#include "ui/widgets/gesture.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QKeyEvent>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QMouseEvent>
#include <QScrollBar>
#include <QTabBar>
#include <QToolBar>

namespace fumage::ui {

namespace {

constexpr const char* kAllButtons = "allButtons"; ///< dynamic property

/// Lists that stand in a window, not those that a combo box opens: the right button selects what its menu is about.
bool isListInWindow(const QWidget& widget)
{
    return qobject_cast<const QAbstractItemView*>(widget.parentWidget()) != nullptr
        && !widget.window()->windowFlags().testFlag(Qt::Popup);
}

bool hasUseFor(const QWidget& widget, Qt::MouseButton button)
{
    // Menus can be drawn open with the right button; a scroll bar is no value.
    return button == Qt::LeftButton || widget.property(kAllButtons).toBool()
        || qobject_cast<const QMenu*>(&widget) != nullptr || qobject_cast<const QScrollBar*>(&widget) != nullptr
        || (button == Qt::RightButton && isListInWindow(widget));
}

/// Qt looks after these drags itself, over windows that come and go while they last.
bool isDraggedByQt(const QWidget& widget)
{
    return qobject_cast<const QDockWidget*>(&widget) != nullptr || qobject_cast<const QMainWindow*>(&widget) != nullptr
        || qobject_cast<const QToolBar*>(&widget) != nullptr || qobject_cast<const QTabBar*>(&widget) != nullptr
        || qobject_cast<const QMenu*>(&widget) != nullptr || qobject_cast<const QMenuBar*>(&widget) != nullptr
        || qobject_cast<const QComboBox*>(&widget) != nullptr || widget.window()->windowFlags().testFlag(Qt::Popup);
}

bool isDeafToWheel(const QWidget& widget)
{
    if (qobject_cast<const QComboBox*>(&widget) != nullptr || qobject_cast<const QTabBar*>(&widget) != nullptr) {
        return true;
    }
    const bool isNumber = qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr
        || (qobject_cast<const QAbstractSlider*>(&widget) != nullptr
            && qobject_cast<const QScrollBar*>(&widget) == nullptr);
    return isNumber && !widget.hasFocus();
}

} // namespace

void InputGuard::leaveAllButtons(QWidget& widget)
{
    widget.setProperty(kAllButtons, true);
}

bool InputGuard::eventFilter(QObject* watched, QEvent* event)
{
    if (m_held && isEndOfDrag(*watched, *event)) {
        letGo();
    }
    if (event->type() == DragEnd::type()) {
        end(static_cast<DragEnd&>(*event));
        return true;
    }
    if (!watched->isWidgetType()) {
        return false;
    }
    auto& widget = static_cast<QWidget&>(*watched);
    switch (event->type()) {
    case QEvent::Polish:
        if (widget.focusPolicy() == Qt::WheelFocus) {
            widget.setFocusPolicy(Qt::StrongFocus); // or the wheel would first give it the focus
        }
        return false;
    case QEvent::Wheel:
        if (isDeafToWheel(widget)) {
            event->ignore(); // goes on to what is around it
            return true;
        }
        return false;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: return press(widget, static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseMove: return move(widget, static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseButtonRelease: return release(widget, static_cast<const QMouseEvent&>(*event));
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
        if (m_held && static_cast<const QKeyEvent&>(*event).key() == Qt::Key_Escape) {
            event->accept();
            if (event->type() == QEvent::KeyPress && !m_spent) {
                takeBack();
            }
            return true;
        }
        return false;
    default: return false;
    }
}

bool InputGuard::press(QWidget& widget, const QMouseEvent& event)
{
    if (!hasUseFor(widget, event.button())) {
        return true;
    }
    // The release of the last press with this button never came. What does not want a press hands it to what is around
    // it, which is the same press once more.
    if (m_held && m_button == event.button() && (m_spent || !widget.isAncestorOf(m_held))) {
        letGo();
        m_held = nullptr;
    }
    if (!m_held && !isDraggedByQt(widget)) { // a second button begins no drag
        m_held = &widget;
        m_button = event.button();
        m_spent = false;
    }
    return false;
}

bool InputGuard::move(const QWidget& widget, const QMouseEvent& event)
{
    if (m_held && !event.buttons().testFlag(m_button)) {
        letGo();
        m_held = nullptr; // the next press begins anew
    }
    const bool others = event.buttons() != Qt::NoButton && !event.buttons().testFlag(Qt::LeftButton);
    return (m_held && m_spent) || (others && !m_held && !hasUseFor(widget, Qt::MiddleButton));
}

bool InputGuard::release(const QWidget& widget, const QMouseEvent& event)
{
    if (m_held && event.button() == m_button) {
        const bool spent = m_spent;
        m_held = nullptr;
        return spent;
    }
    return !hasUseFor(widget, event.button());
}

bool InputGuard::isEndOfDrag(const QObject& watched, const QEvent& event) const
{
    switch (event.type()) {
    case QEvent::Hide: return &watched == m_held;
    case QEvent::FocusOut: // a menu that the press has opened is a part of the gesture
        return &watched == m_held && static_cast<const QFocusEvent&>(event).reason() != Qt::PopupFocusReason;
    case QEvent::WindowDeactivate:
    case QEvent::WindowBlocked: return &watched == m_held->window();
    default: return false;
    }
}

void InputGuard::letGo()
{
    if (m_spent) {
        return;
    }
    m_spent = true;
    // Outside, so that a button which is held is not pressed by it.
    constexpr QPointF kOutside(-10000.0, -10000.0);
    const QPointer<QWidget> held = std::exchange(m_held, nullptr); // or the event would not get through
    QMouseEvent event(
        QEvent::MouseButtonRelease, kOutside, held->mapToGlobal(kOutside), m_button, Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(held, &event);
    m_held = held;
}

bool InputGuard::takeBack()
{
    const bool isTakenBack = sendDragCancel(m_held);
    if (m_held) {
        letGo();
    }
    return isTakenBack;
}

void InputGuard::end(DragEnd& end)
{
    if (!m_held || m_spent) {
        return; // a button that is still down after its drag changes nothing any more
    }
    if (end.takesBack()) {
        end.setAccepted(takeBack());
    } else {
        letGo();
    }
}

} // namespace fumage::ui
