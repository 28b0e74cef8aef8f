#include "core/simulation/schedule.h"

#include <algorithm>
#include <cmath>

namespace fumage {

namespace {

/// Longer than any timeline: a burst that does not come again.
constexpr std::int64_t kNever = std::int64_t{1} << 40;

constexpr std::int64_t ceilDivide(std::int64_t a, std::int64_t b)
{
    return (a + b - 1) / b;
}

std::int64_t wholeSteps(double seconds, double dt)
{
    // 5 s in steps of 1/30 s are 150 steps although the quotient of the floats is a hair more.
    constexpr double kRoundingOfFloats = 1e-5;
    return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(seconds / dt * (1.0 - kRoundingOfFloats))));
}

} // namespace

std::int64_t Schedule::birthsBefore(std::int64_t step) const
{
    if (step <= 0) {
        return 0;
    }
    const std::int64_t period = step / periodSteps;
    const std::int64_t within = std::min(step - period * periodSteps, windowSteps);
    return period * birthsPerPeriod + ceilDivide(within * birthsPerPeriod, windowSteps);
}

std::int64_t Schedule::birthIndex(std::int64_t step, std::int64_t slot, std::int64_t slots) const
{
    const std::int64_t first = firstAlive(step);
    return first + (slot + slots - first % slots) % slots;
}

std::int64_t Schedule::capacity() const
{
    const std::int64_t rest = lifetimeSteps % periodSteps;
    const std::int64_t inRest =
        rest == 0 ? 0 : std::min(birthsPerPeriod, ceilDivide(rest * birthsPerPeriod, windowSteps) + 1);
    return std::max<std::int64_t>(1, lifetimeSteps / periodSteps * birthsPerPeriod + inRest);
}

float Schedule::actsAfter(std::int64_t step) const
{
    const double left = emittingSteps - static_cast<double>(step % periodSteps);
    constexpr double kRounding = 1e-4; // of a quotient of floats
    if (left > 1.0 - kRounding) {
        return 1.0F;
    }
    return left > kRounding ? static_cast<float>(left) : 0.0F;
}

RowPosition rowPosition(double step, const Schedule& schedule, double cellsPerStep)
{
    const std::int64_t cells = schedule.loopSteps == 0
        ? 0
        : std::max<std::int64_t>(1, std::llround(cellsPerStep * static_cast<double>(schedule.loopSteps)));
    const double position = cells == 0 ? cellsPerStep * step
                                       : std::fmod(step, static_cast<double>(schedule.loopSteps))
            * static_cast<double>(cells) / static_cast<double>(schedule.loopSteps);
    const double cell = std::floor(position);
    RowPosition row;
    row.cells = cells;
    row.before = static_cast<std::int64_t>(cell);
    row.after = cells == 0 ? row.before + 1 : (row.before + 1) % cells;
    row.fraction = static_cast<float>(position - cell);
    return row;
}

Schedule makeSchedule(const SampledEffect& effect)
{
    const Timeline& timeline = effect->timeline;
    const std::int64_t count = effect->emitter.count;
    const double dt = 1.0 / (static_cast<double>(timeline.frameRate) * timeline.stepsPerFrame);

    Schedule schedule;
    schedule.dt = static_cast<float>(dt);
    schedule.stepsPerFrame = timeline.stepsPerFrame;
    schedule.betweenSteps = effect->emitter.subframe;
    schedule.lifetimeSteps =
        wholeSteps(static_cast<double>(effect->life.initialAlpha) / static_cast<double>(effect->life.fadeRate), dt);
    schedule.loopSteps = timeline.loop ? static_cast<std::int64_t>(timeline.length) * timeline.stepsPerFrame : 0;

    const bool burst = effect->emitter.mode == EmissionMode::Burst;
    const bool ends = burst || effect->emitter.length > 0.0F;
    const double seconds = static_cast<double>(burst ? effect->emitter.burstDuration : effect->emitter.length);
    const std::int64_t window = ends ? wholeSteps(seconds, dt) : 0;
    const std::int64_t start = std::llround(static_cast<double>(effect->emitter.start) / dt);
    const std::int64_t lifetime = schedule.lifetimeSteps;
    if (timeline.loop) {
        schedule.periodSteps = schedule.loopSteps;
        schedule.birthsPerPeriod =
            burst ? count / ceilDivide(lifetime, schedule.loopSteps) : count * schedule.loopSteps / lifetime;
        schedule.firstStep = ceilDivide(lifetime + start, schedule.loopSteps) * schedule.loopSteps - start;
    } else {
        schedule.periodSteps = ends ? kNever : lifetime;
        schedule.birthsPerPeriod = count;
        schedule.firstStep = timeline.prewarm && !ends && start == 0 ? lifetime : -start;
    }
    schedule.windowSteps = ends ? std::min(schedule.periodSteps, window) : schedule.periodSteps;
    if (ends && !burst) {
        // As many at a time as if it went on.
        schedule.birthsPerPeriod = timeline.loop
            ? schedule.birthsPerPeriod * schedule.windowSteps / schedule.periodSteps
            : count * schedule.windowSteps / lifetime;
    }
    schedule.birthsPerPeriod = std::max<std::int64_t>(1, schedule.birthsPerPeriod);
    // One that takes no time gives the air its speed and its expansion for as long as a frame of film, whatever a step
    // is.
    constexpr double kShortestBurst = 1.0 / 30.0; // s
    const double emitting = std::max(seconds, kShortestBurst) / dt;
    schedule.emittingSteps = ends ? std::min(static_cast<double>(schedule.periodSteps), emitting)
                                  : static_cast<double>(schedule.periodSteps);
    return schedule;
}

} // namespace fumage
