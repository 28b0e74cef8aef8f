#include "core/simulation/schedule.h"

#include "core/effect/known_parameter.h"

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

/// part / whole of a number, rounded up. The product of the two may be more than an integer holds.
/// @param part 0 to whole
constexpr std::int64_t shareOf(std::int64_t number, std::int64_t part, std::int64_t whole)
{
    return number / whole * part + ceilDivide(number % whole * part, whole);
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
    if (table) {
        const auto steps = static_cast<std::int64_t>(table->before.size()) - 1;
        if (loopSteps != 0) {
            return step / steps * table->before.back() + table->before[static_cast<std::size_t>(step % steps)];
        }
        return step <= steps
            ? table->before[static_cast<std::size_t>(step)]
            : table->before.back() + static_cast<std::int64_t>(static_cast<double>(step - steps) * table->perStep);
    }
    const std::int64_t period = step / periodSteps;
    const std::int64_t within = std::min(step - period * periodSteps, windowSteps);
    return period * birthsPerPeriod + shareOf(birthsPerPeriod, within, windowSteps);
}

std::int64_t Schedule::birthIndex(std::int64_t step, std::int64_t slot, std::int64_t slots) const
{
    const std::int64_t first = firstAlive(step);
    return first + (slot + slots - first % slots) % slots;
}

std::int64_t Schedule::capacity() const
{
    if (table) {
        return table->mostAlive;
    }
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

double secondsOfStep(const Schedule& schedule, const Timeline& timeline, double step)
{
    double since = step - static_cast<double>(schedule.firstStep);
    if (schedule.loopSteps != 0) {
        const auto loop = static_cast<double>(schedule.loopSteps);
        since = std::fmod(since, loop);
        since = since < 0.0 ? since + loop : since;
    }
    return since / (static_cast<double>(timeline.frameRate) * timeline.stepsPerFrame);
}

std::int64_t changingSteps(const Schedule& schedule, const Timeline& timeline, const Track& track)
{
    if (schedule.loopSteps != 0) {
        return schedule.loopSteps;
    }
    constexpr std::int64_t kMax = std::int64_t{1} << 22; // 32 MiB of sums
    const double keyed = std::ceil(track.keys.back().seconds * timeline.frameRate * timeline.stepsPerFrame);
    const std::int64_t shown = static_cast<std::int64_t>(timeline.length) * timeline.stepsPerFrame;
    return std::clamp<std::int64_t>(schedule.firstStep + std::max(shown, static_cast<std::int64_t>(keyed)), 1, kMax);
}

namespace {

/// Where a position lies among cells of which a loop has a whole number, or which have no end.
RowPosition rowAt(double position, std::int64_t cells)
{
    const double cell = std::floor(position);
    RowPosition row;
    row.cells = cells;
    row.before = static_cast<std::int64_t>(cell);
    row.after = cells == 0 ? row.before + 1 : (row.before + 1) % cells;
    row.fraction = static_cast<float>(position - cell);
    return row;
}

} // namespace

RowPosition rowPosition(double step, const Schedule& schedule, double cellsPerStep)
{
    const auto loop = static_cast<double>(schedule.loopSteps);
    const std::int64_t cells =
        schedule.loopSteps == 0 ? 0 : std::max<std::int64_t>(1, std::llround(cellsPerStep * loop));
    return rowAt(cells == 0 ? cellsPerStep * step : std::fmod(step, loop) * static_cast<double>(cells) / loop, cells);
}

RateSum::RateSum(const Track& track, const Schedule& schedule, const Timeline& timeline)
{
    const std::int64_t steps = changingSteps(schedule, timeline, track);
    const auto dt = static_cast<double>(schedule.dt);
    m_before.reserve(static_cast<std::size_t>(steps) + 1);
    double sum = 0.0;
    for (std::int64_t step = 0; step < steps; ++step) {
        m_before.push_back(sum);
        // What lies before frame 0 goes as at its beginning.
        const double seconds = std::max(0.0, secondsOfStep(schedule, timeline, static_cast<double>(step) + 0.5));
        m_perStep = dt * static_cast<double>(std::get<float>(track.at(seconds)));
        sum += m_perStep;
    }
    m_before.push_back(sum);
}

double RateSum::at(double step) const
{
    const auto steps = static_cast<double>(m_before.size() - 1);
    if (step >= steps) {
        return m_before.back() + (step - steps) * m_perStep;
    }
    const double whole = std::floor(step);
    const auto before = static_cast<std::size_t>(whole);
    return m_before[before] + (step - whole) * (m_before[before + 1] - m_before[before]);
}

RowPosition RateSum::row(double step, const Schedule& schedule, double factor) const
{
    if (schedule.loopSteps == 0) {
        return rowAt(at(step) * factor, 0);
    }
    const double total = m_before.back() * factor;
    const std::int64_t cells = std::max<std::int64_t>(1, std::llround(total));
    const double within = std::fmod(step, static_cast<double>(schedule.loopSteps));
    return rowAt(total > 0.0 ? at(within) * factor / total * static_cast<double>(cells) : 0.0, cells);
}

void sumOverAges(const Track& track, const Schedule& schedule, const Timeline& timeline, std::int64_t step,
    float factor, std::vector<float>& out)
{
    // Born between two steps, it has lived for a part of one when it first appears.
    const std::int64_t oldest = std::max<std::int64_t>(0, std::min(schedule.lifetimeSteps, step)) + 1;
    const double each = static_cast<double>(schedule.dt) * static_cast<double>(factor);
    out.clear();
    out.reserve(static_cast<std::size_t>(oldest) + 1);
    double sum = 0.0;
    for (std::int64_t age = 0; age <= oldest; ++age) {
        out.push_back(static_cast<float>(sum));
        const double middle = static_cast<double>(step - age) - 0.5;
        const double seconds = std::max(0.0, secondsOfStep(schedule, timeline, middle));
        sum += each * static_cast<double>(std::get<float>(track.at(seconds)));
    }
}

namespace {

constexpr const Parameter& kRate = knownParameter("emitter.rate");

/// Births that follow a track: those of a schedule without, weighted by what it says in the middle of the time before
/// each step.
BirthTable birthTable(const Track& track, const Schedule& schedule, const Timeline& timeline)
{
    constexpr std::int64_t kWhole = std::int64_t{1} << 20; // of a weight of 1
    const std::int64_t steps = changingSteps(schedule, timeline, track);
    const std::int64_t one = schedule.windowSteps * kWhole;
    // Of births, apart: the product of all of them and a weight may be more than an integer holds.
    const std::int64_t eachStep = schedule.birthsPerPeriod / schedule.windowSteps;
    const std::int64_t beside = schedule.birthsPerPeriod % schedule.windowSteps;
    BirthTable table;
    table.before.reserve(static_cast<std::size_t>(steps) + 1);
    std::int64_t born = 0;
    std::int64_t rest = 0; // of a birth, in parts of one
    std::int64_t weight = 0;
    for (std::int64_t step = 0; step < steps; ++step) {
        table.before.push_back(born + (rest > 0 ? 1 : 0));
        // What appears at a step was born in the time before it.
        const double seconds = std::max(0.0, secondsOfStep(schedule, timeline, static_cast<double>(step) - 0.5));
        const bool emits = step % schedule.periodSteps < schedule.windowSteps;
        weight = emits
            ? std::llround(static_cast<double>(kWhole) * static_cast<double>(std::get<float>(track.at(seconds))))
            : 0;
        rest += weight * eachStep % kWhole * schedule.windowSteps + weight * beside;
        born += weight * eachStep / kWhole + rest / one;
        rest %= one;
    }
    table.before.push_back(born + (rest > 0 ? 1 : 0));
    table.perStep =
        static_cast<double>(weight) * static_cast<double>(schedule.birthsPerPeriod) / static_cast<double>(one);
    return table;
}

/// Most that are alive at once.
std::int64_t mostAlive(const Schedule& schedule)
{
    const auto steps = static_cast<std::int64_t>(schedule.table->before.size()) - 1;
    std::int64_t most = 1;
    for (std::int64_t step = 0; step <= steps + schedule.lifetimeSteps; ++step) {
        // In a loop all turns before are there.
        const std::int64_t at = schedule.loopSteps == 0 ? step : step + schedule.lifetimeSteps;
        most = std::max(most, schedule.birthsBefore(at + 1) - schedule.firstAlive(at));
    }
    return most + 1; // what lies beyond the table is rounded
}

/// How many are born, where it is not all.
void setRate(const SampledEffect& effect, Schedule& schedule)
{
    if (const Track* track = effect.track(kRate)) {
        auto table = std::make_shared<BirthTable>(birthTable(*track, schedule, effect->timeline));
        schedule.birthsPerPeriod =
            schedule.loopSteps == 0 ? schedule.birthsPerPeriod : std::max<std::int64_t>(1, table->before.back());
        schedule.table = table;
        table->mostAlive = mostAlive(schedule);
    } else if (effect->emitter.rate != 1.0F) {
        schedule.birthsPerPeriod =
            std::llround(static_cast<double>(schedule.birthsPerPeriod) * static_cast<double>(effect->emitter.rate));
    }
}

} // namespace

Schedule makeSchedule(const SampledEffect& effect)
{
    const Timeline& timeline = effect->timeline;
    const std::int64_t count = effect->emitter.count;
    const double ofFilm = 1.0 / (static_cast<double>(timeline.frameRate) * timeline.stepsPerFrame);
    const double dt = ofFilm * static_cast<double>(timeline.timeScale);

    Schedule schedule;
    schedule.dt = static_cast<float>(dt);
    schedule.stepsPerFrame = timeline.stepsPerFrame;
    schedule.betweenSteps = effect->emitter.subframe;
    schedule.lifetimeSteps =
        wholeSteps(static_cast<double>(effect->life.initialAlpha) / static_cast<double>(effect->life.fadeRate), dt);
    schedule.loopSteps = timeline.loop ? static_cast<std::int64_t>(timeline.length) * timeline.stepsPerFrame : 0;

    const bool burst = effect->emitter.mode == EmissionMode::Burst;
    const bool ends = burst || effect->emitter.length > 0.0F;
    // How long a burst takes is a matter of the smoke, how long an emitter is on one of the film.
    const auto lasting = static_cast<double>(effect->emitter.length) * static_cast<double>(timeline.timeScale);
    const double seconds = burst ? static_cast<double>(effect->emitter.burstDuration) : lasting;
    const std::int64_t window = ends ? wholeSteps(seconds, dt) : 0;
    const std::int64_t start = std::llround(static_cast<double>(effect->emitter.start) / ofFilm);
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
    setRate(effect, schedule);
    return schedule;
}

std::vector<std::int64_t> birthsOfFrames(const Schedule& schedule, int frames)
{
    std::vector<std::int64_t> births;
    for (int frame = 0; frame < frames; ++frame) {
        const std::int64_t step = schedule.stepOfFrame(frame);
        births.push_back(schedule.birthsBefore(step + 1) - schedule.birthsBefore(step + 1 - schedule.stepsPerFrame));
    }
    return births;
}

} // namespace fumage
