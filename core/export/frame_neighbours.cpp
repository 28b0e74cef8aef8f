#include "core/export/frame_neighbours.h"

#include <algorithm>

namespace fumage {

FrameNeighbours::FrameNeighbours(const SampledEffect& effect, const std::vector<int>& frames, bool wanted, int step, const std::shared_ptr<AirShelf>& shelf)
    : m_simulator(effect, Simulator::kDefaultCheckpointBytes, shelf)
    , m_frames(frames)
    , m_wanted(wanted)
    , m_step(step)
{
}

Result<FrameAmongOthers> FrameNeighbours::at(std::size_t place, const std::stop_token& stop, const Progress& progress)
{
    const std::array<Numbered, 3> last = std::move(m_held);
    m_held = {};
    const int now = m_frames[place];
    const int before = numberBefore(place);
    const int after = numberAfter(place);
    if (m_wanted && before >= 0) {
        if (Status status = fetch(before, last, m_held[0], stop, progress); !status) {
            return status.error();
        }
    }
    if (Status status = fetch(now, last, m_held[1], stop, progress); !status) {
        return status.error();
    }
    if (m_wanted) {
        if (Status status = fetch(after, last, m_held[2], stop, progress); !status) {
            return status.error();
        }
    }
    return FrameAmongOthers{m_held[1].frame.get(), m_held[0].frame.get(), m_held[2].frame.get(), before < 0 ? 1 : now - before, after - now};
}

int FrameNeighbours::numberBefore(std::size_t place) const
{
    if (m_step > 0) {
        return m_frames[place] - m_step;
    }
    return place > 0 ? m_frames[place - 1] : -1;
}

int FrameNeighbours::numberAfter(std::size_t place) const
{
    if (m_step > 0) {
        return m_frames[place] + m_step;
    }
    if (place + 1 < m_frames.size()) {
        return m_frames[place + 1];
    }
    return std::max(0, m_frames[place] + (place > 0 ? m_frames[place] - m_frames[place - 1] : 1));
}

Status FrameNeighbours::fetch(int number, const std::array<Numbered, 3>& last, Numbered& to, const std::stop_token& stop, const Progress& progress)
{
    const auto* const held = std::find_if(last.begin(), last.end(), [&](const Numbered& each) { return each.frame && each.number == number; });
    if (held != last.end()) {
        to = *held;
        return Done{};
    }
    Result<std::shared_ptr<const Frame>> frame = m_simulator.frame(number, stop, progress);
    if (!frame) {
        return frame.error();
    }
    to = {number, std::move(frame).value()};
    return Done{};
}

} // namespace fumage
