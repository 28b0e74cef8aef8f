#pragma once

#include <QTimer>
#include <QWheelEvent>

namespace fumage::ui {

/// Turns of a wheel in notches, away from the hand positive; touchpads send parts of one.
[[nodiscard]] inline double notchesOf(const QWheelEvent& event)
{
    return event.angleDelta().y() / static_cast<double>(QWheelEvent::DefaultDeltasPerStep);
}

/// Steps of the wheel or of a key that follow closely on one another are one gesture, and so one step of undo. start() at each step; the
/// gesture has ended when ended() comes.
class Burst : public QTimer {
    Q_OBJECT

public:
    static constexpr int kRestMs = 500;

    explicit Burst(QObject* parent = nullptr)
        : QTimer(parent)
    {
        setSingleShot(true);
        setInterval(kRestMs);
        connect(this, &QTimer::timeout, this, &Burst::ended);
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
