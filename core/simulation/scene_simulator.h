#pragma once

#include "core/simulation/simulator.h"

#include <vector>

namespace fumage {

/// The smoke of all layers of a scene at one frame.
struct SceneFrame {
    std::vector<std::shared_ptr<const Frame>> layers; ///< in the order of the scene, one or more
};

/// Gives the frames of a scene, in any order: a simulator a layer, all in one air.
///
/// Costs and threads are those of Simulator. Each layer has checkpoints of its own; what particles do depends on their
/// own layer and on the air, and on no other layer.
class SceneSimulator {
public:
    /// @param layers one or more, with the same surroundings
    /// @param checkpointBytes memory that the checkpoints of all layers may take
    /// @param shelf with air that is baked already, or where it is to be kept for others; null: this simulator's own
    explicit SceneSimulator(SampledLayers layers, std::size_t checkpointBytes = Simulator::kDefaultCheckpointBytes,
        const std::shared_ptr<AirCache>& shelf = nullptr);

    /// Takes over the layers of another simulator that are the same here, with their checkpoints: a change of one layer
    /// does not simulate the others again. Of that one nothing is of use afterwards.
    /// @param muted layers that may be seen again: where the other has them, they are kept for the one that adopts this
    void adopt(SceneSimulator& other, SampledLayers muted = {});

    /// How many steps the particles of a layer have to take, all together, until a frame is there; 0: it is at hand.
    [[nodiscard]] double particleSteps(std::size_t layer, int number) const;

    /// @param number 0 or more; in a loop, frames that lie a whole loop apart are one frame
    /// @param progress as of Simulator::frame()
    /// @error Cancelled; that of checkAir(); TooLarge where layers are born on more particles of others than memory
    /// holds
    [[nodiscard]] Result<SceneFrame> frame(int number, const Task& task = {});

    [[nodiscard]] std::size_t layers() const { return m_layers.size(); }
    /// The constants and the schedule that a layer came to.
    [[nodiscard]] const SimulationModel& model(std::size_t layer = 0) const { return m_layers[layer].model(); }

private:
    Status m_status; ///< of checkAir(), and of how many particles layers are born on
    std::vector<Simulator> m_layers;
    std::vector<Simulator> m_muted; ///< in the same air
};

} // namespace fumage
