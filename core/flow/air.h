#pragma once

#include "core/base/result.h"
#include "core/flow/kept_steps.h"
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
    AirBorders borders;
    std::vector<Solid> solids;
    glm::vec3 wind{0.0F}; ///< that it moves with at step 0, m/s
    std::function<AirStep(std::int64_t step)> stepTo; ///< what moves it from step - 1 to step; a pure function, called by one thread at a time
    std::int64_t firstStep = 0; ///< of what is shown; in a loop, from where on it comes again
    std::int64_t loopSteps = 0; ///< 0: it does not loop
};

/// @return memory that the solver of a grid takes, and what it keeps at the least
[[nodiscard]] std::size_t airRoom(const AirGrid& grid);

/// The air of an effect at any step, computed once and kept: a pure function of its plan and the step.
///
/// Steps are computed one after another, from rest at step 0. Their fields are kept as half floats while they fit into the budget; beyond it
/// those farthest from the one asked for go, and are computed again from checkpoints of the whole state when they are asked for again. What
/// is kept never changes bits: all that anybody reads has been rounded once.
///
/// In a loop of L steps the field at t is (1 - t/L) u(F + t + L) + t/L u(F + t), F the first step: it goes over into its own beginning, and a sum
/// of fields without divergence has none.
///
/// Thread-safe: fields may be asked for, and read, while another thread bakes.
class Air {
public:
    /// @param budget memory for fields and checkpoints together
    explicit Air(AirPlan plan, std::size_t budget = kDefaultBudget);

    /// The air at a step, computed if need be.
    /// @error Cancelled
    [[nodiscard]] Result<std::shared_ptr<const AirField>> field(std::int64_t step, const std::stop_token& stop = {});

    /// Computes all steps up to the last one that is shown. Another thread that asks for a field meanwhile waits for no more than a step.
    /// @param last step; in a loop all steps are baked whatever it is
    /// @param progress called now and then with the share that is done, 0 to 1
    /// @error Cancelled; what has been computed is kept
    [[nodiscard]] Status bake(std::int64_t last, const std::stop_token& stop = {}, const std::function<void(double)>& progress = {});

    /// Steps that have been computed at least once, counted from 0.
    [[nodiscard]] std::int64_t bakedSteps() const { return m_baked.load(); }
    /// Memory that fields and checkpoints take now.
    [[nodiscard]] std::size_t keptBytes() const;
    [[nodiscard]] const AirPlan& plan() const { return m_plan; }

    static constexpr std::size_t kDefaultBudget = std::size_t{512} << 20U;

private:
    using Field = std::shared_ptr<const AirField>;

    [[nodiscard]] Field kept(KeptSteps<AirField>& among, std::int64_t step);
    [[nodiscard]] Result<Field> rawField(std::int64_t step, const std::stop_token& stop);
    [[nodiscard]] Result<Field> loopField(std::int64_t step, const std::stop_token& stop);
    /// Moves the solver to the last state before a step that is at hand. @return whether that was a checkpoint
    bool goBackBefore(std::int64_t step);
    [[nodiscard]] Field stepOn();

    AirPlan m_plan;
    std::mutex m_working; ///< held for the solver, a step at a time
    AirSolver m_solver;
    std::int64_t m_at = 0; ///< step that the solver is at
    mutable std::mutex m_keeping; ///< held for what is kept
    KeptSteps<AirField> m_fields;
    KeptSteps<AirField> m_loop; ///< cross-faded, by step of the loop
    SpacedSteps<AirState> m_checkpoints;
    std::atomic<std::int64_t> m_baked{-1};
};

} // namespace fumage
