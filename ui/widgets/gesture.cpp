#include "ui/widgets/gesture.h"

#include <cmath>

#include <QCursor>
#include <QGuiApplication>
#include <QMouseEvent>
#include <QScreen>
#include <QWidget>

namespace fumage::ui {

namespace {

/// Where the pointer comes in again that has come to one end of a screen; where it is anywhere else.
int comingInAgain(int at, int low, int high)
{
    if (at <= low) {
        return high - 1;
    }
    return at >= high ? low + 1 : at;
}

} // namespace

QEvent::Type DragCancel::type()
{
    static const auto registered = static_cast<QEvent::Type>(QEvent::registerEventType());
    return registered;
}

bool sendDragCancel(QWidget* dragged)
{
    DragCancel cancel;
    for (QWidget* to = dragged; to != nullptr && !cancel.isAccepted();
         to = to->isWindow() ? nullptr : to->parentWidget()) {
        QCoreApplication::sendEvent(to, &cancel);
    }
    return cancel.isAccepted();
}

QEvent::Type DragEnd::type()
{
    static const auto registered = static_cast<QEvent::Type>(QEvent::registerEventType());
    return registered;
}

void endDrag()
{
    DragEnd end(false);
    QCoreApplication::sendEvent(qApp, &end);
}

bool takeDragBack()
{
    DragEnd end(true);
    QCoreApplication::sendEvent(qApp, &end);
    return end.isAccepted();
}

void EndlessWay::begin(const QMouseEvent& press)
{
    m_last = press.globalPosition();
    m_way = {};
}

QPointF EndlessWay::to(const QMouseEvent& move)
{
    const QPointF now = move.globalPosition();
    const QRect all = QGuiApplication::primaryScreen()->virtualGeometry();
    QPointF step = now - m_last;
    m_last = now;
    // No hand is that fast: this is the pointer that came in again.
    step.setX(std::abs(step.x()) > all.width() / 2.0 ? 0.0 : step.x());
    step.setY(std::abs(step.y()) > all.height() / 2.0 ? 0.0 : step.y());
    m_way += step;
    const QPoint at = now.toPoint();
    QPoint again = at;
    if (m_along.testFlag(Qt::Horizontal)) {
        again.setX(comingInAgain(at.x(), all.left(), all.right()));
    }
    if (m_along.testFlag(Qt::Vertical)) {
        again.setY(comingInAgain(at.y(), all.top(), all.bottom()));
    }
    if (again != at) {
        QCursor::setPos(again);
    }
    return m_way;
}

} // namespace fumage::ui
