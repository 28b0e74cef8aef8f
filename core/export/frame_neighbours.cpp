#include "core/export/frame_neighbours.h"

#include <algorithm>

namespace fumage {

FrameNeighbours::FrameNeighbours(const SampledEffect& effect, const std::vector<int>& frames, bool wanted)
    : m_simulator(effect)
    , m_frames(frames)
    , m_wanted(wanted)
{
}

Result<FrameAmongOthers> FrameNeighbours::at(std::size_t place, const std::stop_token& stop, const Progress& progress)
{
    m_previous = m_wanted ? std::move(m_now) : nullptr;
    m_now = std::move(m_next);
    if (!m_now) {
        if (Status status = fetch(m_frames[place], m_now, stop, progress); !status) {
            return status.error();
        }
    }
    const int after = numberAfter(place);
    if (m_wanted) {
        if (Status status = fetch(after, m_next, stop, progress); !status) {
            return status.error();
        }
    }
    return FrameAmongOthers{m_now.get(), m_previous.get(), m_next.get(), place == 0 ? 1 : m_frames[place] - m_frames[place - 1], after - m_frames[place]};
}

int FrameNeighbours::numberAfter(std::size_t place) const
{
    if (place + 1 < m_frames.size()) {
        return m_frames[place + 1];
    }
    return std::max(0, m_frames[place] + (place > 0 ? m_frames[place] - m_frames[place - 1] : 1));
}

Status FrameNeighbours::fetch(int number, std::shared_ptr<const Frame>& to, const std::stop_token& stop, const Progress& progress)
{
    Result<std::shared_ptr<const Frame>> frame = m_simulator.frame(number, stop, progress);
    if (!frame) {
        return frame.error();
    }
    to = std::move(frame).value();
    return Done{};
}

} // namespace fumage
