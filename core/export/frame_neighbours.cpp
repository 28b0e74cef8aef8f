#include "core/export/frame_neighbours.h"

#include <algorithm>

namespace fumage {

FrameNeighbours::FrameNeighbours(
    SampledLayers layers, const CellFrames& frames, bool wanted, int step, const std::shared_ptr<AirCache>& shelf)
    : m_layers(layers)
    , m_simulator(layers, Simulator::kDefaultCheckpointBytes, shelf)
    , m_loop(layers.front()->timeline.loop ? layers.front()->timeline.length : 0)
    , m_frames(frames)
    , m_wanted(wanted)
    , m_step(step)
{
}

Result<FrameAmongOthers> FrameNeighbours::at(std::size_t place, const Task& task)
{
    const std::array<Numbered, 3> last = std::move(m_held);
    m_held = {};
    const int now = m_frames.numbers[place];
    const std::optional<int> before = numberBefore(place);
    const int after = numberAfter(place);
    if (m_wanted && before) {
        if (Status status = fetch(*before, last, m_held[0], task); !status) {
            return status.error();
        }
    }
    if (Status status = fetch(now, last, m_held[1], task); !status) {
        return status.error();
    }
    if (m_wanted) {
        if (Status status = fetch(after, last, m_held[2], task); !status) {
            return status.error();
        }
    }
    const auto held = [&](std::size_t which, std::size_t layer) {
        return m_held[which].frame ? m_held[which].frame->layers[layer].get() : nullptr;
    };
    FrameAmongOthers out{{}, before ? now - *before : 1, after - now};
    for (std::size_t layer = 0; layer < m_layers.size(); ++layer) {
        out.layers.push_back({&m_layers[layer], held(1, layer), held(0, layer), held(2, layer)});
    }
    return out;
}

std::optional<int> FrameNeighbours::numberBefore(std::size_t place) const
{
    const std::vector<int>& numbers = m_frames.numbers;
    if (m_step > 0) {
        const int number = numbers[place] - m_step;
        return number >= 0 || m_loop > 0 ? std::optional(number) : std::nullopt;
    }
    if (place > 0) {
        return numbers[place - 1];
    }
    return m_frames.turn ? std::optional(numbers.back() - *m_frames.turn) : std::nullopt;
}

int FrameNeighbours::numberAfter(std::size_t place) const
{
    const std::vector<int>& numbers = m_frames.numbers;
    if (m_step > 0) {
        return numbers[place] + m_step;
    }
    if (place + 1 < numbers.size()) {
        return numbers[place + 1];
    }
    if (m_frames.turn) {
        return numbers.front() + *m_frames.turn;
    }
    return std::max(0, numbers[place] + (place > 0 ? numbers[place] - numbers[place - 1] : 1));
}

Status FrameNeighbours::fetch(int number, const std::array<Numbered, 3>& last, Numbered& to, const Task& task)
{
    number = m_loop > 0 ? (number % m_loop + m_loop) % m_loop : number;
    const auto* const held = std::find_if(
        last.begin(), last.end(), [&](const Numbered& each) { return each.frame && each.number == number; });
    if (held != last.end()) {
        to = *held;
        return Done{};
    }
    Result<SceneFrame> frame = m_simulator.frame(number, task);
    if (!frame) {
        return frame.error();
    }
    to = {number, std::move(frame).value()};
    return Done{};
}

} // namespace fumage
