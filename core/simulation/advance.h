#pragma once

#include "core/base/task.h"
#include "core/base/result.h"
#include "core/simulation/sub_emission.h"
#include "core/simulation/emitter.h"
#include "core/simulation/simulation_model.h"
#include "core/simulation/particles.h"

namespace fumage {

/// Moves all particles from one step to a later one, births and deaths included.
///
/// Particles never act on one another, so each chunk runs through many steps at once while it is in the cache, and
/// chunks run in parallel.
/// @param particles the state at step from; for a later one, empty (see Particles::reset()) where from is before every
/// living birth
/// @param from,to   steps, from <= to
/// @param parents   on whose particles births are, where the model has a parent; null: on the emitter
/// @param task hears of ProgressPhase::PreRoll where there are hundreds of steps, and of ProgressPhase::Air where it
/// has to be baked
/// @error Cancelled, also that of the air; the particles are then between steps and must be thrown away
/// O(particles * steps). The same bits for any number of threads, and for any way to split [from, to].
[[nodiscard]] Status advance(const SimulationModel& model, Particles& particles, std::int64_t from, std::int64_t to,
    SubEmissionSource* parents, const Task& task);

/// The same of what is born on the emitter.
[[nodiscard]] inline Status advance(
    const SimulationModel& model, Particles& particles, std::int64_t from, std::int64_t to, const Task& task = {})
{
    return advance(model, particles, from, to, nullptr, task);
}

/// The same out of place: the state at step from is read, the one at step to written into another.
[[nodiscard]] Status advanceInto(const SimulationModel& model, const Particles& before, Particles& after,
    std::int64_t from, std::int64_t to, SubEmissionSource* parents, const Task& task);

/// Fills the state at a step from nothing, through a pre-roll of at most one lifetime.
[[nodiscard]] Status advanceFromNothing(
    const SimulationModel& model, Particles& particles, std::int64_t to, SubEmissionSource* parents, const Task& task);

/// The same of what is born on the emitter.
[[nodiscard]] inline Status advanceFromNothing(
    const SimulationModel& model, Particles& particles, std::int64_t to, const Task& task = {})
{
    return advanceFromNothing(model, particles, to, nullptr, task);
}

} // namespace fumage
