#pragma once

#include <QObject>
#include <QTimer>

namespace fumage::ui {

/// Which frame is shown, and the clock that moves it on.
///
/// Plays every frame, at most at the frame rate times the speed: a machine that is too slow plays slower and skips
/// nothing.
class Player : public QObject {
    Q_OBJECT

public:
    explicit Player(QObject* parent = nullptr);

    [[nodiscard]] int frame() const { return m_frame; }
    [[nodiscard]] int length() const { return m_length; }
    [[nodiscard]] int first() const { return m_first; } ///< of the range that is played
    [[nodiscard]] int last() const { return m_last; }
    [[nodiscard]] bool isPlaying() const { return m_playing; }
    [[nodiscard]] bool repeats() const { return m_repeats; }
    [[nodiscard]] double speed() const { return m_speed; }

    /// @param frames of the whole timeline, 1 or more; the range is kept where it fits
    void setTimeline(int frames, int frameRate);
    void setRange(int first, int last);
    void setSpeed(double factor);
    void setRepeats(bool repeats);

public slots:
    void setFrame(int frame);
    void play();
    void pause();
    void toggle();
    void stepBy(int frames);
    void toStart();
    void toEnd();

public:
    /// While held, the clock does not move on: the frame that is shown is not there yet.
    void setHeld(bool held) { m_held = held; }
    /// While suspended, nothing runs at all; playing goes on afterwards.
    void setSuspended(bool suspended);

signals:
    void frameChanged(int frame);
    void playingChanged(bool playing);
    void settingsChanged(); ///< length, range, speed, repeat

private:
    void tick();
    void runClock();

    QTimer m_timer;
    int m_frame = 0;
    int m_length = 1;
    int m_first = 0;
    int m_last = 0;
    int m_frameRate = 30;
    double m_speed = 1.0;
    bool m_repeats = true;
    bool m_playing = false;
    bool m_held = false;
    bool m_suspended = false;
};

} // namespace fumage::ui
