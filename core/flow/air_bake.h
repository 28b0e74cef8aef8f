#pragma once

#include "core/base/result.h"
#include "core/flow/step_cache.h"
#include "core/flow/solver.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <vector>

namespace fumage {

/// All that the air depends on.
struct AirPlan {
    AirGrid grid;
    AirBoundaries boundaries;
    std::vector<Solid> solids;
    glm::vec3 wind{0.0F}; ///< that it moves with at step 0, m/s
    std::function<AirStep(std::int64_t step)>
        stepTo; ///< what moves it from step - 1 to step; a pure function, called by one thread at a time
    std::int64_t firstStep = 0; ///< of what is shown, at least loopSteps; in a loop a multiple of them
    std::int64_t loopSteps = 0; ///< 0: it does not loop
    std::size_t parts = 1; ///< of most steps
};

using AirFieldPtr = std::shared_ptr<const AirField>;

/// The air of a plan from rest at step 0 on, one step after another, without its loop.
///
/// Fields are kept as half floats while they fit into the budget; beyond it those farthest from the one asked for go,
/// and are computed again from checkpoints of the whole state when they are asked for again. Thread-safe: fields may be
/// asked for while another thread goes on.
class AirBake {
public:
    /// @param plan that outlives it
    /// @param budget memory for fields and checkpoints together; the least is a few fields and one checkpoint
    AirBake(const AirPlan& plan, std::size_t budget);

    /// The air at a step, computed if need be. Step 0 and those before it are as step 1: what carries newborns is the
    /// first air that has moved.
    /// @error Cancelled
    [[nodiscard]] Result<AirFieldPtr> field(std::int64_t step, const std::stop_token& stop);

    /// Steps that have been computed at least once, counted from 0; -1 before the first.
    [[nodiscard]] std::int64_t bakedSteps() const { return m_baked.load(); }
    /// Memory that fields and checkpoints take now.
    [[nodiscard]] std::size_t keptBytes() const;

private:
    [[nodiscard]] AirFieldPtr kept(std::int64_t step) const;
    /// Moves the solver to the last state before a step that is at hand. @return whether that was a checkpoint
    bool goBackBefore(std::int64_t step);
    [[nodiscard]] AirFieldPtr stepOn();

    const AirPlan& m_plan;
    std::mutex m_working; ///< held for the solver, a step at a time
    AirSolver m_solver;
    std::int64_t m_at = 0; ///< step that the solver is at
    mutable std::mutex m_keeping; ///< held for what is kept
    StepCache<AirField> m_fields;
    SpacedSteps<AirState> m_checkpoints;
    std::atomic<std::int64_t> m_baked{-1};
};

/// Memory that the field of a step takes.
[[nodiscard]] std::size_t fieldBytes(const AirPlan& plan);

/// Memory that a run takes with no more than it needs: its solver, its checkpoint and a few fields.
[[nodiscard]] std::size_t airRoom(const AirPlan& plan);

/// The least budget of a run.
[[nodiscard]] std::size_t leastBudget(const AirPlan& plan);

} // namespace fumage
