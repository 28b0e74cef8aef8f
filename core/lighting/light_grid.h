#pragma once

#include "core/lighting/light_field.h"
#include "core/lighting/lit_layer.h"

#include <glm/vec3.hpp>

namespace fumage {

/// Axes with w along the light.
[[nodiscard]] Axes lightAxes(const glm::vec3& direction);

/// Adds up what the particles around each cell cover, alpha * pi r^2 times appearance.cover, over its volume.
/// Masses of all layers are whole numbers of one unit: smoke is as dense however it is divided into layers.
/// @param layers of which one particle or more is visible
/// @param out gets a vector of zeros after the last cell
void splatParticles(LitLayers layers, const GridShape& shape, LightWorkspace& room, AlignedArray<float>& out);

/// Splats the particles into a grid along given axes: the first half of lightSmoke(), which says how.
/// @param layers with bounds in these axes and one visible particle or more; detail that one has is put into its
/// density
/// @param light  what asks for the density, and how finely
/// @param out    gets shape and densities; the light stays as it is
void fillDensity(LitLayers layers, const Light& light, const Axes& axes, LightWorkspace& room, LightGrid& out);

/// Splats the particles into a grid and lets light through it.
///
/// Each particle is an absorber of cross-section alpha * pi r^2 times the mean of its mask and texture (1/3 for the
/// soft disc, see Coverage); their sum over a cell's volume is its extinction. Sun: optical depth tau by summing along
/// w, then sum over i of s^i p(g / 2^i) exp(-tau 0.35^i), divided by the sum of s^i (Wrenninge, Kulla, Lundqvist, "Oz:
/// The Great and Volumetric", 2013), p the Henyey-Greenstein phase function relative to an isotropic one. Sky and
/// ground: transmittance along the six axis directions, weighted by how much they face up or down. What smoke scatters
/// many times comes on top of both: scatterManyTimes(). Sums are of whole numbers, so that their order does not matter:
/// the same bits for any thread count. Shares of a particle are rounded up or down by its random bits, with their mean
/// kept: thin particles add up to as much smoke as dense ones.
/// @param layers with bounds in lightAxes(effect.light.direction); detail that one has throws shadow
/// @param eye    the camera, m
/// O(particles + cells); as many cells as make a difference to the picture, at most resolution along the longest edge.
/// Where nothing shadows, occludes or asks how many overlap, no particle is looked at.
void lightSmoke(LitLayers layers, const glm::vec3& eye, LightWorkspace& room, LightGrid& out);

} // namespace fumage
