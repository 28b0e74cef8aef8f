#pragma once

#include "core/lighting/fire_workspace.h"
#include "core/lighting/light_field.h"
#include "core/lighting/lit_layer.h"

namespace fumage {

/// Whether what glows lights the smoke around it.
[[nodiscard]] bool isLitByFire(const Glow& glow);

/// Lets what glows light the smoke: the mean radiance that reaches each cell from all particles, whatever their
/// direction.
///
/// Particles give off brightness * alpha * pi r^2 / 3 over a cell's volume, j. What arrives at a distance r of that is
/// exp(-tau) / (4 pi r^2), and 1 / (4 pi r^2) = sqrt(pi / 2) * integral of s G_s(r) d(ln s) over all s, G_s the
/// normalised Gaussian of deviation s: a sum over octaves of s of blurred fields, each blurred on a grid as coarse as
/// it is, and weakened by the smoke within s of the place. Light of one colour, the mean of what glows.
/// @param layers as lightSmoke() was given them; each gives off what its glow.fire_light says
/// @param light  what lightSmoke() has filled; gets fire, its colour and its strength
/// O(particles + cells). Sums have one order: the same bits for any thread count.
void lightByFire(LitLayers layers, FireWorkspace& room, LightWorkspace& splats, LightGrid& light);

} // namespace fumage
