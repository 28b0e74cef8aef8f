#include "ui/shell/shortcut_filter.h"

#include "ui/widgets/field_keys.h"
#include "ui/widgets/physical_key.h"
#include "ui/panels/angle_dial.h"
#include "ui/panels/curve_editor.h"
#include "ui/panels/gradient_editor.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QTextEdit>

namespace fumage::ui {

namespace {

bool isMoving(int key)
{
    switch (key) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Home:
    case Qt::Key_End:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
    case Qt::Key_Insert:
    case Qt::Key_Delete: return true;
    default: return false;
    }
}

bool hasUseFor(const QObject* widget, int key)
{
    if (qobject_cast<const QAbstractButton*>(widget) != nullptr) {
        return key == Qt::Key_Space;
    }
    if (qobject_cast<const QAbstractItemView*>(widget) != nullptr
        || qobject_cast<const QComboBox*>(widget) != nullptr) {
        return key == Qt::Key_Space || isMoving(key) || (key >= Qt::Key_0 && key <= Qt::Key_Z);
    }
    const bool moves = qobject_cast<const QAbstractSlider*>(widget) != nullptr
        || qobject_cast<const AngleDial*>(widget) != nullptr || qobject_cast<const CurveArea*>(widget) != nullptr
        || qobject_cast<const GradientBar*>(widget) != nullptr;
    return moves && isMoving(key);
}

bool takesText(const QObject& widget)
{
    return qobject_cast<const QLineEdit*>(&widget) != nullptr
        || qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr
        || qobject_cast<const QAbstractItemView*>(&widget) != nullptr
        || qobject_cast<const QTextEdit*>(&widget) != nullptr;
}

/// Does what the key means by its place. @return whether it means something
bool actByPlace(const QWidget& widget, const QKeyEvent& event)
{
    const std::optional<int> key = physicalKey(event);
    if (!key || takesText(widget)) {
        return false;
    }
    const auto* itself = qobject_cast<const QMainWindow*>(&widget);
    const QMainWindow* window = itself != nullptr ? itself : mainWindowOf(widget);
    if (window == nullptr) {
        return false;
    }
    const QKeySequence wanted(QKeyCombination(event.modifiers(), static_cast<Qt::Key>(*key)));
    for (QAction* action : window->actions()) {
        const bool isMeant = action->isEnabled() && action->shortcutContext() != Qt::WidgetShortcut;
        if (isMeant && action->shortcuts().contains(wanted)) {
            action->trigger();
            return true;
        }
    }
    return false;
}

/// Once the event is over: what it does may still need the focus.
void leaveSoon(QWidget& field)
{
    QMetaObject::invokeMethod(
        &field, [&field] { leaveField(field); }, Qt::QueuedConnection);
}

} // namespace

bool ShortcutFilter::eventFilter(QObject* watched, QEvent* event)
{
    if (!watched->isWidgetType()) {
        return false;
    }
    auto& widget = static_cast<QWidget&>(*watched);
    switch (event->type()) {
    case QEvent::ShortcutOverride: {
        const auto& key = static_cast<const QKeyEvent&>(*event);
        const bool plain = (key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
        if (plain && hasUseFor(watched, key.key())) {
            event->accept();
            return true;
        }
        return false;
    }
    case QEvent::KeyPress: return actByPlace(widget, static_cast<const QKeyEvent&>(*event));
    case QEvent::Hide:
        if (auto* list = qobject_cast<QComboBox*>(widget.parentWidget()); list != nullptr && widget.isWindow()) {
            leaveSoon(*list);
        }
        return false;
    case QEvent::MouseButtonRelease:
        if (qobject_cast<QAbstractButton*>(&widget) != nullptr && widget.hasFocus()) {
            leaveSoon(widget);
        }
        return false;
    default: return false;
    }
}

} // namespace fumage::ui
