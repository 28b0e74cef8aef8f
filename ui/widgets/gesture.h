#pragma once

#include <QEvent>
#include <QPointF>
#include <QTimer>
#include <QWheelEvent>

class QWidget;

namespace fumage::ui {

/// Turns of a wheel in notches, away from the hand positive; touchpads send parts of one.
[[nodiscard]] inline double wheelSteps(const QWheelEvent& event)
{
    return event.angleDelta().y() / static_cast<double>(QWheelEvent::DefaultDeltasPerStep);
}

/// Tells what is dragged, and then what is around it, that the drag is taken back; whoever accepts it puts back what
/// was there at the press. The release comes after it.
class DragCancel : public QEvent {
public:
    DragCancel()
        : QEvent(type())
    {
        ignore();
    }
    [[nodiscard]] static Type type();
};

/// Sends it to what is dragged, and on to what is around it within its window, until somebody accepts it.
/// @param dragged null: nobody
/// @return whether somebody has
bool sendDragCancel(QWidget* dragged);

/// Tells the one who knows what is held, the InputGuard, that the drag of the mouse is over, though its button is down.
class DragEnd : public QEvent {
public:
    explicit DragEnd(bool takesBack)
        : QEvent(type())
        , m_takesBack(takesBack)
    {
        ignore();
    }
    [[nodiscard]] static Type type();
    /// As Escape does it, and not by a release.
    [[nodiscard]] bool takesBack() const { return m_takesBack; }

private:
    bool m_takesBack;
};

/// Before something else is done to what may be dragged: lets go of it, where anything is held.
void endDrag();
/// Takes the drag of the mouse back, as Escape does; what cannot be taken back is let go.
/// @return whether there was a drag that was taken back
bool takeDragBack();

/// The way of a mouse that is dragged, as if the screen had no edges: where it ends, the pointer comes in again at the
/// other side.
class EndlessWay {
public:
    /// @param along the ways that are of interest
    explicit EndlessWay(Qt::Orientations along = Qt::Horizontal | Qt::Vertical)
        : m_along(along)
    {
    }
    void begin(const QMouseEvent& press);
    /// @return pixels since the press
    [[nodiscard]] QPointF to(const QMouseEvent& move);

private:
    QPointF m_last; ///< on the screen
    QPointF m_way;
    Qt::Orientations m_along;
};

/// Steps of the wheel or of a key that follow closely on one another are one gesture, and so one step of undo. start()
/// at each step; the gesture has ended when ended() comes.
class GestureTimer : public QTimer {
    Q_OBJECT

public:
    static constexpr int kRestMs = 500;

    explicit GestureTimer(QObject* parent = nullptr)
        : QTimer(parent)
    {
        setSingleShot(true);
        setInterval(kRestMs);
        connect(this, &QTimer::timeout, this, &GestureTimer::ended);
    }

    /// The hand does something else: the gesture ends now.
    void end()
    {
        if (isActive()) {
            stop();
            emit ended();
        }
    }

signals:
    void ended();
};

} // namespace fumage::ui
