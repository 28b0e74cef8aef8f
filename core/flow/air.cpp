#include "core/flow/air.h"

#include "core/flow/blend_kernel.h"

#include <algorithm>
#include <cassert>

namespace fumage {

namespace {

bool fits(const AirPlan& plan, std::size_t budget)
{
    return plan.loopSteps > 0
        && static_cast<std::size_t>(plan.loopSteps) * fieldBytes(plan) + leastBudget(plan) <= budget;
}

std::size_t budgetOfRun(const AirPlan& plan, std::size_t budget)
{
    if (plan.loopSteps == 0) {
        return budget;
    }
    return fits(plan, budget) ? leastBudget(plan) : budget / 2;
}

/// out = late + share (early - late), part by part: steps a turn apart have the same ones.
void blend(const AirField& late, const AirField& early, float share, AirField& out)
{
    out.wind = late.wind + share * (early.wind - late.wind);
    out.share = late.share;
    out.obstacle = late.obstacle; // steps a turn apart have the same
    blendFields(late, early, share, out);
    assert(late.earlier.size() == early.earlier.size());
    out.earlier.assign(late.earlier.size(), AirField(late.grid));
    for (std::size_t i = 0; i < late.earlier.size(); ++i) {
        blend(late.earlier[i], early.earlier[i], share, out.earlier[i]);
    }
}

} // namespace

BakedAir::BakedAir(AirPlan plan, std::size_t budget)
    : m_plan(std::move(plan))
    , m_run(m_plan, budgetOfRun(m_plan, budget))
{
    if (m_plan.loopSteps == 0) {
        return;
    }
    if (fits(m_plan, budget)) {
        m_turn.resize(static_cast<std::size_t>(length()));
        m_passed = m_plan.firstStep - 1;
    } else {
        m_behind = std::make_unique<AirBake>(m_plan, budgetOfRun(m_plan, budget));
    }
}

std::int64_t BakedAir::timeInTurn(std::int64_t step) const
{
    const std::int64_t time = (step - turnStart()) % length();
    return time < 0 ? time + length() : time;
}

AirFieldPtr BakedAir::faded(const AirFieldPtr& late, const AirFieldPtr& early, std::int64_t time) const
{
    const float share = static_cast<float>(time - length() + fade()) / static_cast<float>(fade());
    auto field = std::make_shared<AirField>(m_plan.grid);
    blend(*late, *early, share, *field);
    return field;
}

Status BakedAir::passOn(const std::stop_token& stop)
{
    const std::scoped_lock pass(m_passing);
    const std::int64_t step = m_passed + 1;
    if (step > lastRawStep(0)) {
        return Done{};
    }
    const Result<AirFieldPtr> raw = m_run.field(step, stop);
    if (!raw) {
        return raw.error();
    }
    const std::int64_t time = timeInTurn(step);
    AirFieldPtr& place = m_turn[static_cast<std::size_t>(time)];
    const bool isEarly = step < turnStart();
    const AirFieldPtr field = isEarly || time <= length() - fade() ? raw.value() : faded(raw.value(), place, time);
    const std::scoped_lock lock(m_keeping);
    place = field;
    m_passed = step;
    return Done{};
}

AirFieldPtr BakedAir::ready(std::int64_t time) const
{
    const std::scoped_lock lock(m_keeping);
    return m_passed >= turnStart() + time ? m_turn[static_cast<std::size_t>(time)] : nullptr;
}

Result<AirFieldPtr> BakedAir::field(std::int64_t step, const std::stop_token& stop)
{
    if (length() == 0) {
        return m_run.field(step, stop);
    }
    const std::int64_t time = timeInTurn(step);
    if (inOnePass()) {
        while (true) {
            if (AirFieldPtr field = ready(time)) {
                return field;
            }
            if (const Status status = passOn(stop); !status) {
                return status.error();
            }
        }
    }
    Result<AirFieldPtr> late = m_run.field(turnStart() + time, stop);
    if (!late || time <= length() - fade()) {
        return late;
    }
    const Result<AirFieldPtr> early = m_behind->field(turnStart() + time - length(), stop);
    return early ? Result<AirFieldPtr>(faded(late.value(), early.value(), time)) : early;
}

Status BakedAir::bakeStep(std::int64_t step, const std::stop_token& stop)
{
    if (inOnePass() && step >= m_plan.firstStep) {
        return passOn(stop);
    }
    const Result<AirFieldPtr> made = m_run.field(step, stop);
    return made ? Status(Done{}) : made.error();
}

Status BakedAir::bake(std::int64_t last, const std::stop_token& stop, const std::function<void(double)>& progress)
{
    const std::int64_t end = std::max<std::int64_t>(1, lastRawStep(last));
    while (m_run.bakedSteps() < end) {
        if (Status status = bakeStep(std::max<std::int64_t>(1, m_run.bakedSteps() + 1), stop); !status) {
            return status;
        }
        if (progress) {
            progress(std::min(1.0, static_cast<double>(m_run.bakedSteps()) / static_cast<double>(end)));
        }
    }
    return Done{};
}

std::size_t BakedAir::keptBytes() const
{
    std::size_t bytes = m_run.keptBytes() + (m_behind ? m_behind->keptBytes() : 0);
    const std::scoped_lock lock(m_keeping);
    for (const AirFieldPtr& field : m_turn) {
        bytes += field ? field->bytes() : 0;
    }
    return bytes;
}

} // namespace fumage
