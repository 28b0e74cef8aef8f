#include "core/simulation/advance.h"

#include "core/base/hash.h"
#include "core/base/parallel.h"
#include "core/simulation/step.h"

#include <algorithm>
#include <vector>

namespace fumage {

namespace {

/// Steps whose constants are kept at once: a pre-roll of any length takes this much memory.
constexpr std::int64_t kStepsAtOnce = 128;

/// The particles [first, last) of consecutive birth index that fall into slots [begin, end), in up to two laps of the ring.
template <class Visit>
void forSlots(std::int64_t first, std::int64_t last, std::int64_t capacity, std::int64_t begin, std::int64_t end, const Visit& visit)
{
    for (std::int64_t lap = first / capacity * capacity; lap < last; lap += capacity) {
        const std::int64_t low = std::max(first, lap + begin);
        const std::int64_t high = std::min(last, lap + end);
        for (std::int64_t index = low; index < high; ++index) {
            visit(index, static_cast<std::size_t>(index - lap));
        }
    }
}

class ChunkRunner {
public:
    ChunkRunner(const Model& model, Particles& particles)
        : m_model(model)
        , m_schedule(model.schedule())
        , m_birthPlace(model.effect().emitter, m_schedule.dt)
        , m_particles(particles)
    {
    }

    void run(std::size_t chunk, std::span<const StepConstants> steps) const
    {
        const auto begin = static_cast<std::int64_t>(chunk * Particles::kChunk);
        const std::int64_t end = std::min<std::int64_t>(begin + static_cast<std::int64_t>(Particles::kChunk), static_cast<std::int64_t>(m_particles.capacity));
        bool occupied = !empty(chunk);
        for (const StepConstants& constants : steps) {
            if (occupied) {
                stepChunk(constants, m_particles, chunk);
            }
            const std::int64_t step = constants.step;
            forSlots(m_schedule.birthsBefore(step), m_schedule.birthsBefore(step + 1), static_cast<std::int64_t>(m_particles.capacity), begin, end,
                [&](std::int64_t index, std::size_t slot) {
                    bear(index, slot, constants.step);
                    occupied = true;
                });
        }
    }

    /// Empties the slots of a chunk whose particles are not alive at a step.
    void bury(std::size_t chunk, std::int64_t step) const
    {
        const std::size_t begin = chunk * Particles::kChunk;
        for (std::size_t slot = begin; slot < begin + Particles::kChunk; ++slot) {
            const std::int64_t birth = m_particles.birthStep[slot];
            if (birth > step || birth + m_schedule.lifetimeSteps <= step) {
                clear(slot);
            }
        }
    }

private:
    [[nodiscard]] bool empty(std::size_t chunk) const
    {
        const auto begin = m_particles.birthStep.begin() + static_cast<std::ptrdiff_t>(chunk * Particles::kChunk);
        return std::all_of(begin, begin + static_cast<std::ptrdiff_t>(Particles::kChunk), [](std::int32_t birth) { return birth == Particles::kUnborn; });
    }

    void bear(std::int64_t index, std::size_t slot, std::int32_t step) const
    {
        const std::uint32_t key = birthKey(m_model.effect().emitter.seed, static_cast<std::uint64_t>(m_schedule.randomIndex(index)));
        const Birth born = m_birthPlace.birth(key);
        put(slot, born, key, step);
    }

    void clear(std::size_t slot) const { put(slot, Birth{}, 0, Particles::kUnborn); }

    void put(std::size_t slot, const Birth& born, std::uint32_t key, std::int32_t step) const
    {
        m_particles.x[slot] = born.position.x;
        m_particles.y[slot] = born.position.y;
        m_particles.z[slot] = born.position.z;
        m_particles.vx[slot] = born.velocity.x;
        m_particles.vy[slot] = born.velocity.y;
        m_particles.vz[slot] = born.velocity.z;
        m_particles.key[slot] = key;
        m_particles.birthStep[slot] = step;
    }

    const Model& m_model;
    const Schedule& m_schedule;
    BirthPlace m_birthPlace;
    Particles& m_particles;
};

template <class Column>
void copyChunk(const Column& from, Column& to, std::size_t chunk)
{
    const auto begin = static_cast<std::ptrdiff_t>(chunk * Particles::kChunk);
    std::copy_n(from.begin() + begin, Particles::kChunk, to.begin() + begin);
}

void copyChunk(const Particles& from, Particles& to, std::size_t chunk)
{
    copyChunk(from.x, to.x, chunk);
    copyChunk(from.y, to.y, chunk);
    copyChunk(from.z, to.z, chunk);
    copyChunk(from.vx, to.vx, chunk);
    copyChunk(from.vy, to.vy, chunk);
    copyChunk(from.vz, to.vz, chunk);
    copyChunk(from.key, to.key, chunk);
    copyChunk(from.birthStep, to.birthStep, chunk);
}

/// @param prepare called for a chunk before its first step
template <class Prepare>
Status run(const Model& model, Particles& particles, std::int64_t from, std::int64_t to, const std::stop_token& stop, const Prepare& prepare)
{
    const ChunkRunner runner(model, particles);
    std::vector<StepConstants> steps;
    bool first = true;
    std::int64_t done = from;
    do {
        const std::int64_t last = std::min(to, done + kStepsAtOnce);
        steps.clear();
        for (std::int64_t step = done + 1; step <= last; ++step) {
            steps.push_back(model.constants(step));
        }
        parallelFor(particles.chunks(), [&](std::size_t chunk) {
            if (stop.stop_requested()) {
                return;
            }
            if (first) {
                prepare(chunk);
            }
            runner.run(chunk, steps);
            if (last == to) {
                runner.bury(chunk, to);
            }
        });
        if (stop.stop_requested()) {
            return Error{ErrorCode::Cancelled, "the simulation was cancelled", "", ""};
        }
        first = false;
        done = last;
    } while (done < to);
    return Done{};
}

} // namespace

Status advance(const Model& model, Particles& particles, std::int64_t from, std::int64_t to, std::stop_token stop)
{
    return run(model, particles, from, to, stop, [](std::size_t) {});
}

Status advanceInto(const Model& model, const Particles& before, Particles& after, std::int64_t from, std::int64_t to, std::stop_token stop)
{
    if (after.x.size() != before.x.size()) {
        after.reset(before.capacity);
    }
    after.capacity = before.capacity;
    return run(model, after, from, to, stop, [&](std::size_t chunk) { copyChunk(before, after, chunk); });
}

Status advanceFromNothing(const Model& model, Particles& particles, std::int64_t to, std::stop_token stop)
{
    particles.reset(static_cast<std::size_t>(model.schedule().capacity()));
    const std::int64_t from = std::max<std::int64_t>(-1, to - model.schedule().lifetimeSteps);
    return run(model, particles, from, to, stop, [](std::size_t) {});
}

} // namespace fumage
