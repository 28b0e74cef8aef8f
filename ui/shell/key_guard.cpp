#include "ui/shell/key_guard.h"

#include "ui/panels/angle_dial.h"
#include "ui/panels/curve_editor.h"
#include "ui/panels/gradient_editor.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QComboBox>
#include <QKeyEvent>

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
    if (qobject_cast<const QAbstractItemView*>(widget) != nullptr || qobject_cast<const QComboBox*>(widget) != nullptr) {
        return key == Qt::Key_Space || isMoving(key) || (key >= Qt::Key_0 && key <= Qt::Key_Z);
    }
    const bool moves = qobject_cast<const QAbstractSlider*>(widget) != nullptr || qobject_cast<const AngleDial*>(widget) != nullptr
        || qobject_cast<const CurveArea*>(widget) != nullptr || qobject_cast<const GradientBar*>(widget) != nullptr;
    return moves && isMoving(key);
}

} // namespace

bool KeyGuard::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = static_cast<const QKeyEvent&>(*event);
        const bool plain = (key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
        if (plain && hasUseFor(watched, key.key())) {
            event->accept();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

} // namespace fumage::ui
