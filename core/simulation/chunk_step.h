#pragma once

#include "core/simulation/emitter.h"
#include "core/simulation/simulation_model.h"
#include "core/simulation/particles.h"
#include "core/simulation/sub_emission.h"

#include <span>
#include <vector>

namespace fumage {

/// The columns that the particles of an effect need.
[[nodiscard]] Particles::Columns columnsOf(const SimulationModel& model);

/// The parts of a step: one of it all, or as many as its air has.
/// @param air of the step, which has to outlive them, or nullptr
void findParts(const SimulationModel& model, std::int64_t step, const AirField* air, std::vector<StepConstants>& out);

/// Moves one chunk of particles by one step: by carryChunk() where air carries them, else by stepChunk().
/// @param parts of the step
/// Thread-safe for different chunks.
void moveChunk(std::span<const StepConstants> parts, Particles& particles, std::size_t chunk);

/// Gives birth to particles of consecutive index and moves them through the part of the step that they have lived.
/// @param parts of the step at which they first appear
/// @param randomIndex of the first, see spawnParticles()
/// @param slot,end  slots [slot, end) of one chunk
/// @param on of each where it is born on another layer's; empty: at the emitter
/// Thread-safe for different chunks.
void spawnInChunk(const Spawner& place, std::span<const StepConstants> parts, std::int64_t randomIndex,
    std::size_t slot, std::size_t end, std::span<const SubEmission> on, Particles& particles);

} // namespace fumage
