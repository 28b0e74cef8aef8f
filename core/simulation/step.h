#pragma once

#include "core/simulation/simulation_model.h"
#include "core/simulation/particles.h"

#include <span>

namespace fumage {

/// Moves one chunk of particles by one step, in place. Slots that are not alive are moved too; nothing reads them.
///
/// The vortex turns P about its axis; then acc = a (1 - r + r rand() sqrt(n)) for each component, n the steps of a
/// frame, V += (acc - D V) tau, then P += (W + u) dt, with u the velocity of turbulence and rings at P and W that of
/// the flight, then the rotation of the whole cloud. tau = (1 - e^(-D dt)) / D, which makes V' = acc - D V exact
/// whatever the step, is dt without drag. W dt is the way of the same solution, V tau + acc (dt - tau) / D; without
/// drag W is the new V. V stays within kMaxSpeed. With everything of part 2 at zero this is eq. III to V and IX to XII
/// of the 2012 model.
/// @param chunk index below particles.chunks()
/// Thread-safe for different chunks. The same bits on every instruction set.
void stepChunk(const StepConstants& constants, Particles& particles, std::size_t chunk);

/// Moves particles that were born during a step from where they were born through the part of the step that they have
/// lived: smoke then leaves along the air that carries it as a stream, and not in plates a step apart.
/// @param constants of the step at which they first appear, which is their birth step
/// @param first,last slots [first, last) of one chunk
/// Thread-safe for different chunks. The same bits on every instruction set.
void stepNewParticles(const StepConstants& constants, Particles& particles, std::size_t first, std::size_t last);

/// Evaluates the turbulence of a step at points, m/s, as stepChunk() does for particles older than the onset.
/// @param x,y,z        positions, m; all spans have the same length
/// @param vx,vy,vz     results
void turbulenceAt(const StepConstants& constants, std::span<const float> x, std::span<const float> y,
    std::span<const float> z, std::span<float> vx, std::span<float> vy, std::span<float> vz);

} // namespace fumage
