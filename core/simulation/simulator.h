#pragma once

#include "core/simulation/advance.h"
#include "core/simulation/air_cache.h"
#include "core/simulation/sub_emitter.h"
#include "core/simulation/checkpoints.h"
#include "core/simulation/frame.h"

#include <memory>
#include <vector>

namespace fumage {

/// Gives the frames of one effect, in any order.
///
/// Playing forwards costs one frame's steps; a jump costs those since the nearest checkpoint, and at most one lifetime.
/// Not thread-safe; each worker has its own. Frames that were handed out may be read by any thread.
class Simulator {
public:
    /// @param checkpointBytes memory that checkpoints may take
    /// @param shelf with air that is baked already, or where it is to be kept for others; null: this simulator's own
    explicit Simulator(const SampledEffect& effect, std::size_t checkpointBytes = kDefaultCheckpointBytes,
        const std::shared_ptr<AirCache>& shelf = nullptr);

    /// Of a layer whose model is at hand.
    explicit Simulator(
        std::shared_ptr<const SimulationModel> model, std::size_t checkpointBytes = kDefaultCheckpointBytes);

    /// @param number 0 or more; in a loop, frames that lie a whole loop apart are one frame
    /// @param task hears of ProgressPhase::PreRoll where many steps lead to the frame, and of ProgressPhase::Air where
    /// it has to be baked
    /// @error Cancelled; that of checkAir()
    [[nodiscard]] Result<std::shared_ptr<const Frame>> frame(int number, const Task& task = {});

    /// How many steps each particle has to take on average until a frame is there; 0: it is at hand.
    [[nodiscard]] double stepsTo(int number) const;

    /// The constants and the schedule that the effect came to.
    [[nodiscard]] const SimulationModel& model() const { return *m_model; }
    [[nodiscard]] const std::shared_ptr<const SimulationModel>& sharedModel() const { return m_model; }

    static constexpr std::size_t kDefaultCheckpointBytes = std::size_t{256} << 20U;

private:
    /// Of a loop, the frame of its first turn.
    [[nodiscard]] int inLoop(int number) const;
    [[nodiscard]] std::shared_ptr<const Frame> nearestBefore(int number) const;
    [[nodiscard]] std::shared_ptr<Frame> blankFrame();

    Status m_airStatus; ///< of checkAir()
    std::shared_ptr<const SimulationModel> m_model;
    std::unique_ptr<SubEmitter> m_subEmitter; ///< where they are on another layer's particles
    Checkpoints m_checkpoints;
    std::shared_ptr<const Frame> m_latest;
    std::vector<std::shared_ptr<Frame>> m_pool; ///< frames to write into again once nobody else holds them
};

} // namespace fumage
