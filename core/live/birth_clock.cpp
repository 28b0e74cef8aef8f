#include "core/live/birth_clock.h"

#include <cmath>

namespace fumage {

std::int64_t BirthClock::next(const Schedule& schedule, float share)
{
    constexpr std::int64_t kParts = 65536;
    if (!emits(schedule)) {
        ++m_step;
        return 0;
    }
    ++m_step;
    const std::int64_t window = schedule.windowSteps * kParts;
    if (window != m_window) {
        m_owed =
            std::llround(static_cast<double>(m_owed) / static_cast<double>(m_window) * static_cast<double>(window));
        m_window = window;
    }
    m_owed += schedule.birthsPerPeriod * std::lround(share * static_cast<float>(kParts));
    const std::int64_t births = m_owed > 0 ? (m_owed + window - 1) / window : 0;
    m_owed -= births * window;
    return births;
}

} // namespace fumage
