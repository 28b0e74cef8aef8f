#pragma once

#include "core/simulation/emitter.h"
#include "core/simulation/model.h"
#include "core/simulation/particles.h"

namespace fumage {

/// The columns that the particles of an effect need.
[[nodiscard]] Particles::Columns columnsOf(const Model& model);

/// Moves one chunk of particles by one step: by carryChunk() where air carries them, else by stepChunk().
/// Thread-safe for different chunks.
void moveChunk(const StepConstants& constants, Particles& particles, std::size_t chunk);

/// Gives birth to particles of consecutive index and moves them through the part of the step that they have lived.
/// @param constants of the step at which they first appear
/// @param randomIndex of the first, see bearParticles()
/// @param slot,end  slots [slot, end) of one chunk
/// Thread-safe for different chunks.
void bearInChunk(const BirthPlace& place, const StepConstants& constants, std::int64_t randomIndex, std::size_t slot, std::size_t end, Particles& particles);

} // namespace fumage
