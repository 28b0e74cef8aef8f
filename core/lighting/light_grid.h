#pragma once

#include "core/lighting/detail_field.h"
#include "core/lighting/light_field.h"
#include "core/simulation/frame.h"

#include <glm/vec3.hpp>

namespace fumage {

/// Axes with w along the light.
[[nodiscard]] Axes lightAxes(const glm::vec3& direction);

/// Adds up what the particles around each cell cover, alpha * pi r^2 times appearance.cover, over its volume.
/// @param out gets a vector of zeros after the last cell
void splatParticles(const Frame& frame, const Appearance& appearance, const GridShape& shape, LightWorkspace& room,
    AlignedArray<float>& out);

/// Splats the particles into a grid along given axes: the first half of lightSmoke(), which says how.
/// @param appearance of the same frame, with bounds in these axes and one visible particle or more
/// @param detail     that is put into the density; null: none
/// @param out        gets shape and densities; the light stays as it is
void fillDensity(const Frame& frame, const SampledEffect& effect, const Appearance& appearance, const Axes& axes,
    const DetailField* detail, LightWorkspace& room, LightGrid& out);

/// Splats the particles into a grid and lets light through it.
///
/// Each particle is an absorber of cross-section alpha * pi r^2 times the mean of its mask and texture (1/3 for the
/// soft disc, see Coverage); their sum over a cell's volume is its extinction. Sun: optical depth tau by summing along
/// w, then sum over i of s^i p(g / 2^i) exp(-tau 0.35^i), divided by the sum of s^i (Wrenninge, Kulla, Lundqvist, "Oz:
/// The Great and Volumetric", 2013), p the Henyey-Greenstein phase function relative to an isotropic one. Sky and
/// ground: transmittance along the six axis directions, weighted by how much they face up or down. Sums are of whole
/// numbers, so that their order does not matter: the same bits for any thread count. Shares of a particle are rounded
/// up or down by its random bits, with their mean kept: thin particles add up to as much smoke as dense ones.
/// @param appearance of the same frame, with bounds in lightAxes(effect.light.direction)
/// @param eye        the camera, m
/// @param detail     that the smoke has, and that throws shadow on itself; null: none
/// O(particles + cells); as many cells as make a difference to the picture, at most resolution along the longest edge.
/// Where nothing shadows, occludes or asks how many overlap, no particle is looked at.
void lightSmoke(const Frame& frame, const SampledEffect& effect, const Appearance& appearance, const glm::vec3& eye,
    const DetailField* detail, LightWorkspace& room, LightGrid& out);

} // namespace fumage
