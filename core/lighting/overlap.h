#pragma once

#include "core/lighting/light_grid.h"

namespace fumage {

/// What inflateSparseParticles() needs while it works; kept, so that its memory is allocated once.
struct OverlapWorkspace {
    GridShape shape; ///< of cells about as large as particles
    AlignedArray<float> density; ///< extinction in them, 1/m
    AlignedArray<float> around; ///< the same over the neighbourhood of each
    int factor = 0; ///< how many cells of the light one of them is long; 0: nothing is found yet

    /// Before the first layer of a picture: what was found is of another light.
    void forget() { factor = 0; }
};

/// Lets particles grow where few overlap, so that smoke ends as haze and not as dots.
///
/// With D the extinction around a particle without its own, n = 4/3 r D / (alpha c) others overlap it, c being what of
/// a disc it covers: there are D / (alpha pi r^2 c) of its kind in a volume, times that of a ball of its radius. Where
/// 1 + n is below effect.look.overlap, the radius grows by the cube root of what lacks, at most threefold, and the
/// alpha shrinks by its square: the particle covers as much as before, and light does not change.
/// @param light      of the same frame, with density
/// @param room       of the same light, or forgotten: layers whose particles are about as large find its density once
/// @param appearance as lightSmoke() was given it
/// O(particles + cells). The same bits for any thread count and instruction set.
void inflateSparseParticles(const Frame& frame, const SampledEffect& effect, const LightGrid& light,
    OverlapWorkspace& room, Appearance& appearance);

} // namespace fumage
