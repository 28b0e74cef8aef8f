#pragma once

#include "core/rendering/pass_renderer.h"
#include "core/simulation/simulator.h"

#include <memory>
#include <vector>

namespace fumage {

/// Hands out frames, each with those beside it, and where they rise simulates none twice.
class FrameNeighbours {
public:
    /// @param frames in any order, but one that rises is quick; must stay
    /// @param wanted whether those beside are; else there is none
    FrameNeighbours(const SampledEffect& effect, const std::vector<int>& frames, bool wanted);

    /// @param place of a frame in the list: 0, then one more each time
    /// @return the frame until the next call; after the last comes one that is as far behind it as that is behind the one before, or the first of all
    /// @error those of Simulator
    [[nodiscard]] Result<FrameAmongOthers> at(std::size_t place, const std::stop_token& stop, const Progress& progress);

private:
    [[nodiscard]] int numberAfter(std::size_t place) const;
    [[nodiscard]] Status fetch(int number, std::shared_ptr<const Frame>& to, const std::stop_token& stop, const Progress& progress);

    Simulator m_simulator;
    const std::vector<int>& m_frames;
    bool m_wanted;
    std::shared_ptr<const Frame> m_previous;
    std::shared_ptr<const Frame> m_now;
    std::shared_ptr<const Frame> m_next;
};

} // namespace fumage
