#include "core/flow/air_bake.h"

#include <algorithm>

namespace fumage {

namespace {

/// Of the budget, for checkpoints: 1 / this.
constexpr std::size_t kShareOfCheckpoints = 4;

/// Of the fields that are kept, how many are computed beyond the one asked for after going back to a checkpoint: the
/// next ones are asked for next.
constexpr std::size_t kShareAhead = 4;

constexpr std::size_t kMinFields = 4;

std::size_t stateBytes(const AirGrid& grid)
{
    return 2 * QuadLayout(grid.cells).size * sizeof(float);
}

std::size_t mostCheckpoints(const AirGrid& grid, std::size_t budget)
{
    return std::max<std::size_t>(1, budget / kShareOfCheckpoints / stateBytes(grid));
}

std::size_t mostFields(const AirPlan& plan, std::size_t budget)
{
    const std::size_t states = mostCheckpoints(plan.grid, budget) * stateBytes(plan.grid);
    return std::max(kMinFields, (budget - std::min(budget, states)) / fieldBytes(plan));
}

} // namespace

std::size_t fieldBytes(const AirPlan& plan)
{
    return plan.parts * AirField(plan.grid).bytes();
}

std::size_t leastBudget(const AirPlan& plan)
{
    return stateBytes(plan.grid) + kMinFields * fieldBytes(plan);
}

std::size_t airRoom(const AirPlan& plan)
{
    // of AirCells, of the levels of the pressure together, and of the curl around a few threads
    constexpr std::size_t kColumns = 16;
    return stateBytes(plan.grid) + kColumns * ColumnLayout(plan.grid.cells).size * sizeof(float) + leastBudget(plan);
}

AirBake::AirBake(const AirPlan& plan, std::size_t budget)
    : m_plan(plan)
    , m_solver(plan.grid, plan.boundaries, plan.solids, plan.wind)
    , m_fields(mostFields(plan, budget))
    , m_checkpoints(mostCheckpoints(plan.grid, budget))
{
    m_checkpoints.keep(0, m_solver.state());
}

AirFieldPtr AirBake::kept(std::int64_t step) const
{
    const std::scoped_lock lock(m_keeping);
    return m_fields.find(step);
}

bool AirBake::goBackBefore(std::int64_t step)
{
    const auto* checkpoint = m_checkpoints.lastBefore(step - 1);
    const bool canGoOn = m_at < step && (checkpoint == nullptr || checkpoint->first <= m_at);
    if (canGoOn || checkpoint == nullptr) {
        return false;
    }
    m_solver.restore(checkpoint->second);
    m_at = checkpoint->first;
    return true;
}

AirFieldPtr AirBake::stepOn()
{
    auto field = std::make_shared<AirField>(m_plan.grid);
    m_solver.step(m_plan.stepTo(m_at + 1), *field);
    ++m_at;
    const std::scoped_lock lock(m_keeping);
    m_fields.keep(m_at, field);
    if (m_checkpoints.wants(m_at)) {
        m_checkpoints.keep(m_at, m_solver.state());
    }
    m_baked.store(std::max(m_baked.load(), m_at));
    return field;
}

Result<AirFieldPtr> AirBake::field(std::int64_t step, const std::stop_token& stop)
{
    step = std::max<std::int64_t>(1, step);
    bool wentBack = false;
    AirFieldPtr wanted = kept(step);
    while (!wanted) {
        if (stop.stop_requested()) {
            return Error{ErrorCode::Cancelled, makeMessage("the air was cancelled"), {}, {}};
        }
        const std::scoped_lock lock(m_working);
        wanted = kept(step); // another thread may have come first
        if (wanted) {
            return wanted;
        }
        wentBack = goBackBefore(step) || wentBack;
        const AirFieldPtr next = stepOn();
        if (m_at == step) {
            wanted = next;
        }
    }
    if (wentBack) {
        const std::scoped_lock lock(m_working);
        const std::int64_t ahead = step + static_cast<std::int64_t>(m_fields.most() / kShareAhead);
        const std::int64_t last = std::min(ahead, bakedSteps());
        while (m_at >= step && m_at < last && !stop.stop_requested()) {
            (void)stepOn();
        }
    }
    return wanted;
}

std::size_t AirBake::keptBytes() const
{
    const std::scoped_lock lock(m_keeping);
    return m_fields.count() * fieldBytes(m_plan) + m_checkpoints.count() * stateBytes(m_plan.grid);
}

} // namespace fumage
