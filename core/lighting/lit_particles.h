#pragma once

#include "core/lighting/particle_light.h"
#include "core/simulation/frame.h"

#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace fumage {

/// Finds the colour of each particle in its light, as its sprite has it: what the sun and everything else give,
/// together.
/// @param appearance,grid of the same frame, with all light
/// @param out linear, one a slot: red, green and blue not multiplied by the opacity, which is the fourth; 0 where
/// nobody is seen
/// O(particles). The same bits for any thread count and instruction set.
void findLitColours(const Frame& frame, const SampledEffect& effect, const Appearance& appearance,
    const LightGrid& grid, std::vector<glm::vec4>& out);

/// What findNormals() needs while it works; kept, so that its memory is allocated once.
struct NormalWorkspace {
    AlignedArray<float> outwards; ///< four floats a cell, of which three are the way to thinner smoke in the axes, 1/m
    AlignedArray<float> room;
};

/// Finds the way out of the smoke at each particle: against the gradient of its density, which is that of the cells
/// beside, softened as light is.
/// @param appearance,grid of the same frame, with density
/// @param out one a slot, of length 1 in the axes of the world; 0 where nobody is seen, and where there is no way out
/// because smoke is as dense all around or has no density since nothing throws shadow
/// O(particles + cells). The same bits for any thread count and instruction set.
void findNormals(const Frame& frame, const Appearance& appearance, const LightGrid& grid, NormalWorkspace& room,
    std::vector<glm::vec3>& out);

} // namespace fumage
