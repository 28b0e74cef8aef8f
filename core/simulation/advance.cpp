#include "core/simulation/advance.h"

#include "core/base/parallel.h"
#include "core/simulation/chunk_step.h"
#include "core/simulation/particle_ring.h"

#include <algorithm>
#include <span>
#include <vector>

namespace fumage {

namespace {

/// Steps whose constants are kept at once: a pre-roll of any length takes this much memory.
constexpr std::int64_t kStepsAtOnce = 128;

/// The same where air carries the particles: each step has a field, which takes more than its constants.
constexpr std::int64_t kStepsAtOnceInAir = 4;

/// A step with the births that it has.
struct PlannedStep {
    Spawner spawner;
    std::vector<StepConstants> parts;
    std::shared_ptr<const AirField> air;
    std::int64_t firstBirth = 0;
    std::int64_t endBirth = 0;
    std::vector<SubEmission> on; ///< of each birth, where they are on another layer's particles
};

class ChunkRunner {
public:
    ChunkRunner(const SimulationModel& model, Particles& particles)
        : m_schedule(model.schedule())
        , m_particles(particles)
        , m_ring(particles)
    {
    }

    /// @param from the step that the chunk's state is at
    void run(std::size_t chunk, std::int64_t from, std::span<const PlannedStep> steps) const
    {
        bool occupied = m_ring.reaches(chunk, m_schedule.firstAlive(from), firstUnborn(from));
        for (const PlannedStep& step : steps) {
            if (occupied) {
                moveChunk(step.parts, m_particles, chunk);
            }
            m_ring.forChunk(
                chunk, step.firstBirth, step.endBirth, [&](std::int64_t low, std::int64_t high, std::size_t slot) {
                    spawn(low, high, slot, step);
                    occupied = true;
                });
        }
    }

    /// Empties the slots of a chunk whose particles are not alive at a step.
    void retire(std::size_t chunk, std::int64_t step) const
    {
        m_ring.clearOthers(m_particles, chunk, m_schedule.firstAlive(step), firstUnborn(step));
    }

private:
    [[nodiscard]] std::int64_t firstUnborn(std::int64_t step) const { return m_schedule.birthsBefore(step + 1); }

    /// Gives birth to particles [first, last) of one lap, in runs that do not pass the end of a loop.
    void spawn(std::int64_t first, std::int64_t last, std::size_t slot, const PlannedStep& step) const
    {
        while (first < last) {
            const std::int64_t random = m_schedule.randomIndex(first);
            const std::int64_t count =
                m_schedule.loopSteps == 0 ? last - first : std::min(last - first, m_schedule.birthsPerPeriod - random);
            const std::size_t end = slot + static_cast<std::size_t>(count);
            const std::span<const SubEmission> on = step.on.empty()
                ? std::span<const SubEmission>()
                : std::span(step.on).subspan(static_cast<std::size_t>(first - step.firstBirth), end - slot);
            spawnInChunk(step.spawner, step.parts, random, slot, end, on, m_particles);
            slot = end;
            first += count;
        }
    }

    const Schedule& m_schedule;
    Particles& m_particles;
    ParticleRing m_ring;
};

/// Plans steps (from, to].
Result<std::vector<PlannedStep>> plannedSteps(const SimulationModel& model, std::int64_t from, std::int64_t to,
    SubEmissionSource* parents, const std::stop_token& stop)
{
    std::vector<PlannedStep> steps;
    for (std::int64_t step = from + 1; step <= to; ++step) {
        PlannedStep& planned = steps.emplace_back(PlannedStep{model.spawnerAt(step), {}, nullptr,
            model.schedule().birthsBefore(step), model.schedule().birthsBefore(step + 1), {}});
        if (model.air() != nullptr) {
            const auto field = model.air()->field(model.airStep(step), stop);
            if (!field) {
                return field.error();
            }
            planned.air = field.value();
        }
        findParts(model, step, planned.air.get(), planned.parts);
        if (parents != nullptr) {
            if (Status status =
                    parents->find(model, step, planned.firstBirth, planned.endBirth, planned.on, Task(stop));
                !status) {
                return status.error();
            }
        }
    }
    return steps;
}

/// Bakes the air of all steps up to one, so that somebody hears how far it is.
Status bakeAir(const SimulationModel& model, std::int64_t last, const Task& task)
{
    if (model.air() == nullptr || model.air()->isBaked(model.airStep(last))) {
        return Done{};
    }
    constexpr int kParts = 1000;
    return model.air()->bake(model.airStep(last), task.stop,
        [&](double share) { task.progress(ProgressPhase::Air, static_cast<int>(share * kParts), kParts); });
}

/// What prepares a chunk that needs nothing.
constexpr auto kAsItIs = [](std::size_t) {};

/// @param prepare called for a chunk before its first step
template <class Prepare>
Status run(const SimulationModel& model, Particles& particles, std::int64_t from, std::int64_t to,
    const Prepare& prepare, SubEmissionSource* parents, const Task& task)
{
    const ChunkRunner runner(model, particles);
    if (Status status = bakeAir(model, to, task); !status) {
        return status;
    }
    const std::int64_t atOnce = model.air() != nullptr ? kStepsAtOnceInAir : kStepsAtOnce;
    bool first = true;
    std::int64_t done = from;
    do {
        const std::int64_t last = std::min(to, done + atOnce);
        const Result<std::vector<PlannedStep>> planned = plannedSteps(model, done, last, parents, task.stop);
        if (!planned) {
            return planned.error();
        }
        const std::vector<PlannedStep>& steps = planned.value();
        parallelFor(particles.chunks(), [&](std::size_t chunk) {
            if (task.stopped()) {
                return;
            }
            if (first) {
                prepare(chunk);
            }
            runner.run(chunk, done, steps);
            if (last == to) {
                runner.retire(chunk, to);
            }
        });
        if (task.stopped()) {
            return Error{ErrorCode::Cancelled, makeMessage("the simulation was cancelled"), {}, {}};
        }
        first = false;
        done = last;
        if (to - from > kStepsAtOnce) {
            task.progress(ProgressPhase::PreRoll, static_cast<int>(done - from), static_cast<int>(to - from));
        }
    } while (done < to);
    return Done{};
}

} // namespace

Status advance(const SimulationModel& model, Particles& particles, std::int64_t from, std::int64_t to,
    SubEmissionSource* parents, const Task& task)
{
    return run(model, particles, from, to, kAsItIs, parents, task);
}

Status advanceInto(const SimulationModel& model, const Particles& before, Particles& after, std::int64_t from,
    std::int64_t to, SubEmissionSource* parents, const Task& task)
{
    if (after.x.size() != before.x.size() || after.columns() != before.columns()) {
        after.reset(before.capacity, before.columns());
    }
    after.capacity = before.capacity;
    const auto copy = [&](std::size_t chunk) {
        after.copySlots(before, chunk * Particles::kChunk, (chunk + 1) * Particles::kChunk);
    };
    return run(model, after, from, to, copy, parents, task);
}

Status advanceFromNothing(
    const SimulationModel& model, Particles& particles, std::int64_t to, SubEmissionSource* parents, const Task& task)
{
    particles.reset(static_cast<std::size_t>(model.schedule().capacity()), columnsOf(model));
    const std::int64_t from = std::max<std::int64_t>(-1, to - model.schedule().lifetimeSteps);
    return run(model, particles, from, to, kAsItIs, parents, task);
}

} // namespace fumage
