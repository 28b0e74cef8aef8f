#include "ui/widgets/window_keeper.h"

#include <algorithm>

#include <QApplication>
#include <QEvent>
#include <QScreen>
#include <QWidget>
#include <QWindow>

namespace fumage::ui {

namespace {

QMargins knownFrame(const QWidget& window)
{
    const QWindow* handle = window.windowHandle();
    return handle != nullptr && window.isVisible() && !window.isFullScreen() ? handle->frameMargins() : QMargins();
}

/// What the desktop draws around a window. It is known a while after the window has come: until then, that of another
/// window, or one that is usual.
QMargins frameOf(const QWidget& window)
{
    constexpr QMargins kUsual(4, 30, 4, 4);
    if (const QMargins known = knownFrame(window); !known.isNull()) {
        return known;
    }
    for (const QWidget* other : QApplication::topLevelWidgets()) {
        if (const QMargins known = knownFrame(*other); !known.isNull()) {
            return known;
        }
    }
    return kUsual;
}

/// The nearest place at which an area lies in a room, or at least its upper left corner.
QPoint placeInside(const QRect& area, const QRect& room)
{
    return {std::max(room.left(), std::min(area.left(), room.right() + 1 - area.width())),
        std::max(room.top(), std::min(area.top(), room.bottom() + 1 - area.height()))};
}

/// Windows with a title bar; not menus, tips and the like.
bool isFramed(const QWidget& widget)
{
    const Qt::WindowType type = widget.windowType();
    return widget.isWindow() && (type == Qt::Window || type == Qt::Dialog)
        && !widget.windowFlags().testFlag(Qt::FramelessWindowHint);
}

bool isFree(const QWidget& window)
{
    return (window.windowState() & (Qt::WindowMaximized | Qt::WindowFullScreen | Qt::WindowMinimized)) == 0;
}

void keepSize(QWidget& window)
{
    const QMargins frame = frameOf(window);
    const QSize most = window.screen()->availableGeometry().marginsRemoved(frame).size();
    if (window.width() > most.width() || window.height() > most.height()) {
        window.resize(window.size().boundedTo(most));
    }
}

} // namespace

void keepOnScreen(QWidget& window)
{
    if (!isFree(window)) {
        return;
    }
    keepSize(window);
    const QRect outside = window.geometry().marginsAdded(frameOf(window));
    const QPoint place = placeInside(outside, window.screen()->availableGeometry());
    if (place != outside.topLeft()) {
        window.move(place);
    }
}

void placeBeside(const QWidget& window, QWidget& dialog)
{
    const QRect around = window.geometry().marginsAdded(frameOf(window));
    const QRect place(QPoint(around.right() + 1, around.top()), dialog.geometry().marginsAdded(frameOf(dialog)).size());
    dialog.move(placeInside(place, window.screen()->availableGeometry()));
}

bool WindowKeeper::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::KeyPress) {
        m_fresh.clear(); // from now on windows are where the hand wants them
    }
    if (!watched->isWidgetType() || !static_cast<const QWidget*>(watched)->isWindow()) {
        return false;
    }
    auto& window = static_cast<QWidget&>(*watched);
    switch (event->type()) {
    case QEvent::Show:
        if (isFramed(window) && !event->spontaneous()) {
            constexpr int kOpeningMs = 2000; // a slow desktop; then a window that moves is moved by a hand
            m_fresh.insert(&window, QDeadlineTimer(kOpeningMs));
            if (isFree(window)) {
                keepSize(window);
            }
            settle(window);
        }
        break;
    case QEvent::Move:
    case QEvent::Resize:
    case QEvent::WindowActivate: settle(window); break;
    case QEvent::Hide: m_fresh.remove(&window); break;
    default: break;
    }
    return false;
}

/// After the event, and after the desktop has said what frame it has drawn.
void WindowKeeper::settle(QWidget& window)
{
    if (const auto fresh = m_fresh.constFind(&window); fresh != m_fresh.constEnd() && !fresh->hasExpired()) {
        QMetaObject::invokeMethod(
            &window, [&window] { keepOnScreen(window); }, Qt::QueuedConnection);
    }
}

} // namespace fumage::ui
