#pragma once

#include "core/base/vector.h"
#include "core/effect/effect.h"
#include "core/simulation/particles.h"

#include <cstdint>

#include <glm/vec3.hpp>

namespace fumage {

/// Where and how fast particles start: eq. I and II of the 2012 model, with cone and shapes beside.
///
/// I: P uniform on a rectangle (or disc, or in a ball) around the emitter, across its normal N.
/// II: V = speed (Nx (1 - s + s rand()), Ny (1 - s + s positive(rand())), Nz (1 - s + s rand())), s the velocity randomness; s = 1 is the source.
/// With a spread, N is first tilted to any direction of a cone with the same chance: the cosine of the angle is uniform.
struct BirthPlace {
    explicit BirthPlace(const Emitter& from);

    Emitter emitter;
    PlaneBasis basis;
    float coneHeight = 0.0F; ///< 1 - cos(spread): of the cap that the cone cuts from a unit sphere
};

/// Gives birth to particles of consecutive index in consecutive slots.
/// @param randomIndex index of the first as randomness sees it; index + count does not pass the end of a loop
/// @param slot,count  slots [slot, slot + count) of particles
/// The same bits on every instruction set. O(count).
void bearParticles(const BirthPlace& place, std::int64_t randomIndex, std::int32_t step, std::size_t slot, std::size_t count, Particles& particles);

} // namespace fumage
