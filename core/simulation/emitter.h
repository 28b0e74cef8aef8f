#pragma once

#include "core/base/vector.h"
#include "core/effect/effect.h"
#include "core/simulation/particles.h"

#include <cstdint>

#include <glm/vec3.hpp>

namespace fumage {

/// How an emitter has come to its place within the step that particles are born in. A particle that has lived for a
/// share s of the step was born s of the way back: its place and velocity about the emitter are turned with the normal,
/// which goes straight from one to the other and is made a unit again. Without turning, way or velocity it changes no
/// bit.
struct EmitterTravel {
    glm::vec3 way{0.0F}; ///< from where the emitter was a step before, m
    glm::vec3 normalBefore{0.0F, 1.0F, 0.0F}; ///< unit vector, a step before; not opposite to the normal now
    glm::vec3 velocity{0.0F}; ///< that particles take along from it, m/s
    /// Whether particles are born between steps, see Schedule; otherwise all are born at its place now
    bool betweenSteps = false;
};

/// Where and how fast particles start: eq. I and II of the 2012 model, with cone and shapes beside.
///
/// I: P uniform on a rectangle (or disc, or in a ball) around the emitter, across its normal N; or on the rectangle as
/// likely as a picture on it is bright there, whose top is away from the basis's way along.
/// II: V = speed (Nx (1 - s + s rand()), Ny (1 - s + s positive(rand())), Nz (1 - s + s rand())), s the velocity
/// randomness; s = 1 is the source. With a spread, N is first tilted to any direction of a cone with the same chance:
/// the cosine of the angle is uniform.
struct Spawner {
    explicit Spawner(const Emitter& from);
    /// An emitter that has come to its place during the step.
    Spawner(const Emitter& at, const EmitterTravel& coming);

    Emitter emitter;
    PlaneBasis basis;
    bool onPicture = false;
    float coneHeight = 0.0F; ///< 1 - cos(spread): of the cap that the cone cuts from a unit sphere
    EmitterTravel travel;
    bool travels = false;
};

/// Gives birth to particles of consecutive index in consecutive slots.
/// @param randomIndex index of the first as randomness sees it; index + count does not pass the end of a loop
/// @param slot,count  slots [slot, slot + count) of particles
/// The same bits on every instruction set. O(count).
void spawnParticles(const Spawner& place, std::int64_t randomIndex, std::int32_t step, std::size_t slot,
    std::size_t count, Particles& particles);

} // namespace fumage
