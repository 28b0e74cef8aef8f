#include "ui/timeline/player.h"

#include <algorithm>
#include <cmath>

namespace fumage::ui {

namespace {

constexpr double kMillisecondsASecond = 1000.0;
constexpr double kSlowest = 0.05;
constexpr double kFastest = 8.0;

} // namespace

Player::Player(QObject* parent)
    : QObject(parent)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &Player::tick);
}

void Player::setTimeline(int frames, int frameRate)
{
    if (frames == m_length && frameRate == m_frameRate) {
        return;
    }
    const bool whole = m_first == 0 && m_last == m_length - 1;
    m_length = frames;
    m_frameRate = frameRate;
    m_last = whole ? frames - 1 : std::min(m_last, frames - 1);
    m_first = std::min(m_first, m_last);
    runClock();
    emit settingsChanged();
    setFrame(std::min(m_frame, frames - 1));
}

void Player::setRange(int first, int last)
{
    first = std::clamp(first, 0, m_length - 1);
    last = std::clamp(last, first, m_length - 1);
    if (first != m_first || last != m_last) {
        m_first = first;
        m_last = last;
        emit settingsChanged();
    }
}

void Player::setSpeed(double factor)
{
    m_speed = std::clamp(factor, kSlowest, kFastest);
    runClock();
    emit settingsChanged();
}

void Player::setRepeats(bool repeats)
{
    m_repeats = repeats;
    emit settingsChanged();
}

void Player::setFrame(int frame)
{
    frame = std::clamp(frame, 0, m_length - 1);
    if (frame != m_frame) {
        m_frame = frame;
        emit frameChanged(frame);
    }
}

void Player::play()
{
    if (!m_playing) {
        m_playing = true;
        // At the end of a range that does not repeat, play means: again from the start.
        if (m_frame >= m_last && !m_repeats) {
            setFrame(m_first);
        }
        runClock();
        emit playingChanged(true);
    }
}

void Player::pause()
{
    if (m_playing) {
        m_playing = false;
        runClock();
        emit playingChanged(false);
    }
}

void Player::toggle()
{
    m_playing ? pause() : play();
}

void Player::stepBy(int frames)
{
    pause();
    setFrame(m_frame + frames);
}

void Player::toStart()
{
    setFrame(m_first);
}

void Player::toEnd()
{
    setFrame(m_last);
}

void Player::setSuspended(bool suspended)
{
    m_suspended = suspended;
    runClock();
}

void Player::runClock()
{
    if (!m_playing || m_suspended) {
        m_timer.stop();
        return;
    }
    m_timer.start(std::max(1, static_cast<int>(std::lround(kMillisecondsASecond / (m_frameRate * m_speed)))));
}

void Player::tick()
{
    if (m_held) {
        return;
    }
    if (m_frame < m_last) {
        setFrame(std::max(m_frame + 1, m_first));
    } else if (m_repeats) {
        setFrame(m_first);
    } else {
        pause();
    }
}

} // namespace fumage::ui
