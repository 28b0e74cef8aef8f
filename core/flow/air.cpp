#include "core/flow/air.h"

#include "core/flow/blend_kernel.h"

#include <algorithm>

namespace fumage {

namespace {

/// Of the budget, for checkpoints: 1 / this.
constexpr std::size_t kShareOfCheckpoints = 4;

/// Of the fields that are kept, how many are computed beyond the one asked for after going back to a checkpoint: the next ones are asked for next.
constexpr std::size_t kShareAhead = 4;

std::size_t fieldBytes(const AirGrid& grid)
{
    return AirField(grid).bytes();
}

std::size_t stateBytes(const AirGrid& grid)
{
    return 2 * QuadLayout(grid.cells).size * sizeof(float);
}

std::size_t mostFields(const AirPlan& plan, std::size_t budget)
{
    const std::size_t room = budget - budget / kShareOfCheckpoints;
    const std::size_t kinds = plan.loopSteps == 0 ? 1 : 2;
    constexpr std::size_t kFewest = 4;
    return std::max(kFewest, room / fieldBytes(plan.grid) / kinds);
}

Error cancelled()
{
    return {ErrorCode::Cancelled, said("the air was cancelled"), {}, {}};
}

} // namespace

std::size_t airRoom(const AirGrid& grid)
{
    constexpr std::size_t kColumns = 22; // of AirCells, and of the levels of the pressure together
    return 2 * stateBytes(grid) + kColumns * ColumnLayout(grid.cells).size * sizeof(float) + 4 * fieldBytes(grid);
}

Air::Air(AirPlan plan, std::size_t budget)
    : m_plan(std::move(plan))
    , m_solver(m_plan.grid, m_plan.borders, m_plan.solids, m_plan.wind)
    , m_fields(mostFields(m_plan, budget))
    , m_loop(mostFields(m_plan, budget))
    , m_checkpoints(std::max<std::size_t>(1, budget / kShareOfCheckpoints / stateBytes(m_plan.grid)))
{
    m_checkpoints.keep(0, m_solver.state());
}

Air::Field Air::kept(KeptSteps<AirField>& among, std::int64_t step)
{
    const std::scoped_lock lock(m_keeping);
    return among.find(step);
}

bool Air::goBackBefore(std::int64_t step)
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

Air::Field Air::stepOn()
{
    const AirStep step = m_plan.stepTo(m_at + 1);
    m_solver.step(step);
    ++m_at;
    auto field = std::make_shared<AirField>(m_plan.grid);
    field->wind = step.wind;
    m_solver.read(*field);
    const std::scoped_lock lock(m_keeping);
    m_fields.keep(m_at, field);
    if (m_checkpoints.wants(m_at)) {
        m_checkpoints.keep(m_at, m_solver.state());
    }
    m_baked.store(std::max(m_baked.load(), m_at));
    return field;
}

Result<Air::Field> Air::rawField(std::int64_t step, const std::stop_token& stop)
{
    if (step <= 0) {
        step = 1; // at step 0 the air has not been moved: what carries newborns is the first that has
    }
    bool wentBack = false;
    Field wanted = kept(m_fields, step);
    while (!wanted) {
        if (stop.stop_requested()) {
            return cancelled();
        }
        const std::scoped_lock lock(m_working);
        wanted = kept(m_fields, step); // another thread may have come first
        if (wanted) {
            return wanted;
        }
        wentBack = goBackBefore(step) || wentBack;
        const Field next = stepOn();
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

Result<Air::Field> Air::loopField(std::int64_t step, const std::stop_token& stop)
{
    const std::int64_t length = m_plan.loopSteps;
    const std::int64_t within = (step % length + length) % length;
    if (Field done = kept(m_loop, within)) {
        return done;
    }
    const std::int64_t start = m_plan.firstStep + within;
    Result<Field> early = rawField(start, stop);
    if (!early) {
        return early;
    }
    Result<Field> late = rawField(start + length, stop);
    if (!late) {
        return late;
    }
    auto field = std::make_shared<AirField>(*late.value());
    const float share = static_cast<float>(within) / static_cast<float>(length);
    field->wind = late.value()->wind + share * (early.value()->wind - late.value()->wind);
    blendFields(*late.value(), *early.value(), share, *field);
    const std::scoped_lock lock(m_keeping);
    m_loop.keep(within, field);
    return Field(field);
}

Result<std::shared_ptr<const AirField>> Air::field(std::int64_t step, const std::stop_token& stop)
{
    return m_plan.loopSteps == 0 ? rawField(step, stop) : loopField(step, stop);
}

Status Air::bake(std::int64_t last, const std::stop_token& stop, const std::function<void(double)>& progress)
{
    const bool loops = m_plan.loopSteps != 0;
    const std::int64_t rawLast = loops ? m_plan.firstStep + 2 * m_plan.loopSteps : last;
    const std::int64_t end = loops ? m_plan.loopSteps : last + 1;
    const std::int64_t begin = loops ? 0 : std::max<std::int64_t>(1, bakedSteps());
    for (std::int64_t step = begin; step < end; ++step) {
        const Result<Field> made = field(step, stop);
        if (!made) {
            return made.error();
        }
        if (progress) {
            progress(static_cast<double>(std::min(rawLast, bakedSteps())) / static_cast<double>(std::max<std::int64_t>(1, rawLast)));
        }
    }
    return Done{};
}

std::size_t Air::keptBytes() const
{
    const std::scoped_lock lock(m_keeping);
    return (m_fields.count() + m_loop.count()) * fieldBytes(m_plan.grid) + m_checkpoints.count() * stateBytes(m_plan.grid);
}

} // namespace fumage
