#include "core/simulation/advance.h"

#include "core/base/parallel.h"
#include "core/simulation/air_kernel.h"
#include "core/simulation/step.h"

#include <algorithm>
#include <vector>

namespace fumage {

namespace {

/// Steps whose constants are kept at once: a pre-roll of any length takes this much memory.
constexpr std::int64_t kStepsAtOnce = 128;

/// The same where air carries the particles: each step has a field, which takes more than its constants.
constexpr std::int64_t kStepsAtOnceInAir = 4;

/// A step with the births that it has.
struct PlannedStep {
    StepConstants constants;
    std::shared_ptr<const AirField> air;
    std::int64_t firstBirth = 0;
    std::int64_t endBirth = 0;
};

class ChunkRunner {
public:
    ChunkRunner(const Model& model, Particles& particles)
        : m_schedule(model.schedule())
        , m_birthPlace(model.effect()->emitter)
        , m_particles(particles)
        , m_capacity(static_cast<std::int64_t>(particles.capacity))
    {
    }

    /// @param from the step that the chunk's state is at
    void run(std::size_t chunk, std::int64_t from, std::span<const PlannedStep> steps) const
    {
        const Slots slots = slotsOf(chunk);
        bool occupied = false;
        forSlots(m_schedule.firstAlive(from), firstUnborn(from), slots, [&](std::int64_t, std::int64_t, std::int64_t) { occupied = true; });
        for (const PlannedStep& step : steps) {
            if (occupied) {
                const auto move = step.air ? &carryChunk : &stepChunk;
                move(step.constants, m_particles, chunk);
            }
            forSlots(step.firstBirth, step.endBirth, slots, [&](std::int64_t low, std::int64_t high, std::int64_t lap) {
                bear(low, high, lap, step.constants);
                occupied = true;
            });
        }
    }

    /// Empties the slots of a chunk whose particles are not alive at a step.
    void bury(std::size_t chunk, std::int64_t step) const
    {
        const std::int64_t first = m_schedule.firstAlive(step);
        const std::int64_t last = firstUnborn(step);
        const Slots slots = slotsOf(chunk);
        if (last - first < m_capacity) {
            // The ring's free slots are those of the births that come next.
            forSlots(last, first + m_capacity, slots, [&](std::int64_t low, std::int64_t high, std::int64_t lap) {
                clear(low - lap, high - lap);
            });
        }
        clear(std::max(slots.begin, slots.end), static_cast<std::int64_t>((chunk + 1) * Particles::kChunk)); // padding
    }

private:
    /// Slots [begin, end) of a chunk without padding.
    struct Slots {
        std::int64_t begin, end;
    };

    [[nodiscard]] Slots slotsOf(std::size_t chunk) const
    {
        const auto begin = static_cast<std::int64_t>(chunk * Particles::kChunk);
        return {begin, std::min(begin + static_cast<std::int64_t>(Particles::kChunk), m_capacity)};
    }

    /// Visits the particles [first, last) of consecutive birth index that fall into some slots, lap by lap of the ring.
    template <class Visit>
    void forSlots(std::int64_t first, std::int64_t last, const Slots& slots, const Visit& visit) const
    {
        for (std::int64_t lap = first / m_capacity * m_capacity; lap < last; lap += m_capacity) {
            const std::int64_t low = std::max(first, lap + slots.begin);
            const std::int64_t high = std::min(last, lap + slots.end);
            if (low < high) {
                visit(low, high, lap);
            }
        }
    }

    [[nodiscard]] std::int64_t firstUnborn(std::int64_t step) const { return m_schedule.birthsBefore(step + 1); }

    /// Gives birth to particles [first, last) of one lap, in runs that do not pass the end of a loop.
    void bear(std::int64_t first, std::int64_t last, std::int64_t lap, const StepConstants& constants) const
    {
        while (first < last) {
            const std::int64_t random = m_schedule.randomIndex(first);
            const std::int64_t count = m_schedule.loopSteps == 0 ? last - first : std::min(last - first, m_schedule.birthsPerPeriod - random);
            const auto slot = static_cast<std::size_t>(first - lap);
            const std::size_t end = slot + static_cast<std::size_t>(count);
            m_particles.clearRoll(slot, end);
            bearParticles(m_birthPlace, random, constants.step, slot, end - slot, m_particles);
            if (constants.air.field != nullptr) {
                carryNewborns(constants, m_particles, slot, end);
            } else if (constants.betweenSteps) {
                stepNewborns(constants, m_particles, slot, end);
            }
            first += count;
        }
    }

    void clear(std::int64_t first, std::int64_t last) const { m_particles.clear(static_cast<std::size_t>(first), static_cast<std::size_t>(last)); }

    const Schedule& m_schedule;
    BirthPlace m_birthPlace;
    Particles& m_particles;
    std::int64_t m_capacity;
};

/// Plans steps (from, to].
Result<std::vector<PlannedStep>> plannedSteps(const Model& model, std::int64_t from, std::int64_t to, const std::stop_token& stop)
{
    std::vector<PlannedStep> steps;
    for (std::int64_t step = from + 1; step <= to; ++step) {
        PlannedStep& planned = steps.emplace_back(PlannedStep{model.constants(step), nullptr, model.schedule().birthsBefore(step), model.schedule().birthsBefore(step + 1)});
        if (model.air() != nullptr) {
            const auto field = model.air()->field(step, stop);
            if (!field) {
                return field.error();
            }
            planned.air = field.value();
            planned.constants.air.field = planned.air.get();
        }
    }
    return steps;
}

/// Bakes the air of all steps up to one, so that somebody hears how far it is.
Status bakeAir(const Model& model, std::int64_t last, const std::stop_token& stop, const Progress& progress)
{
    if (model.air() == nullptr || model.air()->isBaked(last)) {
        return Done{};
    }
    constexpr int kParts = 1000;
    return model.air()->bake(last, stop, [&](double share) { progress(Work::Air, static_cast<int>(share * kParts), kParts); });
}

/// @param prepare called for a chunk before its first step
template <class Prepare>
Status run(const Model& model, Particles& particles, std::int64_t from, std::int64_t to, const std::stop_token& stop, const Progress& progress, const Prepare& prepare)
{
    const ChunkRunner runner(model, particles);
    if (Status status = bakeAir(model, to, stop, progress); !status) {
        return status;
    }
    const std::int64_t atOnce = model.air() != nullptr ? kStepsAtOnceInAir : kStepsAtOnce;
    bool first = true;
    std::int64_t done = from;
    do {
        const std::int64_t last = std::min(to, done + atOnce);
        const Result<std::vector<PlannedStep>> planned = plannedSteps(model, done, last, stop);
        if (!planned) {
            return planned.error();
        }
        const std::vector<PlannedStep>& steps = planned.value();
        parallelFor(particles.chunks(), [&](std::size_t chunk) {
            if (stop.stop_requested()) {
                return;
            }
            if (first) {
                prepare(chunk);
            }
            runner.run(chunk, done, steps);
            if (last == to) {
                runner.bury(chunk, to);
            }
        });
        if (stop.stop_requested()) {
            return Error{ErrorCode::Cancelled, said("the simulation was cancelled"), {}, {}};
        }
        first = false;
        done = last;
        if (to - from > kStepsAtOnce) {
            progress(Work::PreRoll, static_cast<int>(done - from), static_cast<int>(to - from));
        }
    } while (done < to);
    return Done{};
}

} // namespace

Status advance(const Model& model, Particles& particles, std::int64_t from, std::int64_t to, const std::stop_token& stop, const Progress& progress)
{
    return run(model, particles, from, to, stop, progress, [](std::size_t) {});
}

Status advanceInto(const Model& model, const Particles& before, Particles& after, std::int64_t from, std::int64_t to, const std::stop_token& stop, const Progress& progress)
{
    if (after.x.size() != before.x.size() || after.columns() != before.columns()) {
        after.reset(before.capacity, before.columns());
    }
    after.capacity = before.capacity;
    return run(model, after, from, to, stop, progress, [&](std::size_t chunk) { after.copySlots(before, chunk * Particles::kChunk, (chunk + 1) * Particles::kChunk); });
}

Status advanceFromNothing(const Model& model, Particles& particles, std::int64_t to, const std::stop_token& stop, const Progress& progress)
{
    const bool inAir = model.air() != nullptr;
    const Look& look = model.effect()->look;
    particles.reset(static_cast<std::size_t>(model.schedule().capacity()), {.rolls = look.roll > 0.0F, .inAir = inAir, .deforms = inAir && look.deformation > 0.0F});
    const std::int64_t from = std::max<std::int64_t>(-1, to - model.schedule().lifetimeSteps);
    return run(model, particles, from, to, stop, progress, [](std::size_t) {});
}

} // namespace fumage
