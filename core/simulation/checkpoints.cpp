#include "core/simulation/checkpoints.h"

#include <cstdlib>

namespace fumage {

void Checkpoints::offer(const std::shared_ptr<const Frame>& frame, int spacing)
{
    const int number = frame->number;
    const std::size_t each = frame->particles.bytes();
    if (number % spacing != 0 || each > m_bytes || m_frames.contains(number)) {
        return;
    }
    if ((m_frames.size() + 1) * each > m_bytes) {
        const auto first = m_frames.begin();
        const auto last = std::prev(m_frames.end());
        const bool firstIsFarther = std::abs(first->first - number) > std::abs(last->first - number);
        m_frames.erase(firstIsFarther ? first : last);
    }
    m_frames.emplace(number, frame);
}

std::shared_ptr<const Frame> Checkpoints::nearestBefore(int number) const
{
    const auto after = m_frames.upper_bound(number);
    return after == m_frames.begin() ? nullptr : std::prev(after)->second;
}

} // namespace fumage
