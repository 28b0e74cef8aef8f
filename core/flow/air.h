#pragma once

#include "core/flow/air_bake.h"

#include <algorithm>

namespace fumage {

/// The air of an effect at any step, computed once and kept: a pure function of its plan and the step. What is kept
/// never changes bits: all that anybody reads has been rounded once.
///
/// A loop of L steps goes over into its own beginning in its last M = L / 2 steps. With A = F + M, F the first step,
/// and t = s - A for the s in [A, A + L) that comes at the same place of the loop, the field is u(A + t) up to t = L -
/// M, and then (1 - w) u(A + t) + w u(A + t - L), w = (t - L + M) / M. A sum of fields without divergence has none. A
/// loop whose fields fit into the budget is computed in one pass; a longer one by two runs side by side, one of them a
/// turn behind.
///
/// Thread-safe: fields may be asked for, and read, while another thread bakes.
class BakedAir {
public:
    /// @param budget memory for fields and checkpoints together; what the solvers work in comes on top, see airRoom()
    explicit BakedAir(AirPlan plan, std::size_t budget = kDefaultBudget);

    /// The air at a step, computed if need be; in a loop at its place in the turn.
    /// @error Cancelled
    [[nodiscard]] Result<AirFieldPtr> field(std::int64_t step, const std::stop_token& stop = {});

    /// Computes all steps up to the last one that is shown. Another thread that asks for a field meanwhile waits for no
    /// more than a step.
    /// @param last step; in a loop all steps are baked whatever it is
    /// @param progress called now and then with the share that is done, 0 to 1
    /// @error Cancelled; what has been computed is kept
    [[nodiscard]] Status bake(
        std::int64_t last, const std::stop_token& stop = {}, const std::function<void(double)>& progress = {});

    /// Whether all steps up to one have been computed at least once; of a loop, all there are.
    [[nodiscard]] bool isBaked(std::int64_t last) const { return missingSteps(last) == 0; }
    /// How many steps bake() would have to compute.
    [[nodiscard]] std::int64_t missingSteps(std::int64_t last) const
    {
        return std::max<std::int64_t>(0, lastRawStep(last) - m_run.bakedSteps());
    }
    /// Memory that fields and checkpoints take now.
    [[nodiscard]] std::size_t keptBytes() const;
    [[nodiscard]] const AirPlan& plan() const { return m_plan; }

    static constexpr std::size_t kDefaultBudget = std::size_t{512} << 20U;

private:
    /// Steps of a loop and of the way into its beginning.
    [[nodiscard]] std::int64_t length() const { return m_plan.loopSteps; }
    [[nodiscard]] std::int64_t fade() const { return std::max<std::int64_t>(1, m_plan.loopSteps / 2); }
    /// A, where the turn that is shown begins.
    [[nodiscard]] std::int64_t turnStart() const { return m_plan.firstStep + fade(); }
    [[nodiscard]] std::int64_t lastRawStep(std::int64_t last) const
    {
        return length() == 0 ? last : turnStart() + length() - 1;
    }
    /// Place in the turn of a step, 0 to L - 1.
    [[nodiscard]] std::int64_t timeInTurn(std::int64_t step) const;

    /// Whether all fields of the loop are kept, and so made in one pass.
    [[nodiscard]] bool inOnePass() const { return !m_turn.empty(); }
    /// The field at a time in the turn, of the run and of what it goes over into.
    [[nodiscard]] AirFieldPtr faded(const AirFieldPtr& late, const AirFieldPtr& early, std::int64_t time) const;
    Status bakeStep(std::int64_t step, const std::stop_token& stop);
    /// Takes the pass on by one step, if it is not at its end.
    Status passOn(const std::stop_token& stop);
    /// What is ready of the turn, or nullptr.
    [[nodiscard]] AirFieldPtr ready(std::int64_t time) const;

    AirPlan m_plan;
    AirBake m_run;
    std::unique_ptr<AirBake> m_behind; ///< a turn behind; only in loops that do not fit into the budget
    std::mutex m_passing; ///< held for a step of the pass
    mutable std::mutex m_keeping; ///< held for the turn
    std::vector<AirFieldPtr>
        m_turn; ///< by time in the turn; while the pass goes on those of the last M are the early ones
    std::int64_t m_passed = 0; ///< raw step that the pass has come to
};

} // namespace fumage
