#pragma once

#include "core/rendering/pass_renderer.h"
#include "core/simulation/scene_simulator.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace fumage {

/// The frames of the cells of a sheet, and how it goes on after the last.
struct CellFrames {
    std::vector<int> numbers;
    std::optional<int> turn{}; ///< the first is shown again after the last, so many frames after it was shown before;
                               ///< none: the last is the end
};

/// Hands out frames, each with those beside it, and where they rise simulates none twice.
class FrameNeighbours {
public:
    /// @param layers must stay
    /// @param frames in any order, but one that rises is quick; must stay
    /// @param wanted whether those beside are; else there is none
    /// @param shelf  with air that others bake or have baked; null: none
    /// @param step   0: those beside are the ones in the list; else those that are so many frames away, whatever is in
    /// the list, so that frames are the same however they are divided into lists
    FrameNeighbours(SampledLayers layers, const CellFrames& frames, bool wanted, int step = 0,
        const std::shared_ptr<AirCache>& shelf = nullptr);

    /// @param place of a frame in the list: 0, then one more each time
    /// @return the frame until the next call; where the sheet ends, after the last comes one that is as far behind it
    /// as that is behind the one before, or the first of all
    /// @error those of Simulator
    [[nodiscard]] Result<FrameAmongOthers> at(std::size_t place, const Task& task);

private:
    struct Numbered {
        int number = 0;
        std::optional<SceneFrame> frame; ///< none: there is none
    };

    /// None: there is none. In a loop numbers may be less than 0, and those after the last may be theirs: they lie in
    /// other turns of it.
    [[nodiscard]] std::optional<int> numberBefore(std::size_t place) const;
    [[nodiscard]] int numberAfter(std::size_t place) const;
    /// A frame, which may be one that was handed out last.
    [[nodiscard]] Status fetch(int number, const std::array<Numbered, 3>& last, Numbered& to, const Task& task);

    SampledLayers m_layers;
    SceneSimulator m_simulator;
    int m_loop; ///< frames after which all is as it was; 0: there is no loop
    const CellFrames& m_frames;
    bool m_wanted;
    int m_step;
    std::array<Numbered, 3> m_held; ///< the one before, the frame, the one after
};

} // namespace fumage
