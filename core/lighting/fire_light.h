#pragma once

#include "core/lighting/light_grid.h"

#include <vector>

namespace fumage {

/// Numbers at the cells of a grid, u fastest.
struct GridField {
    int nu = 0, nv = 0, nw = 0;
    AlignedArray<float> values;

    void resize(int u, int v, int w);
    /// The cells along u at one v and w.
    [[nodiscard]] float* line(int v, int w) { return values.data() + lineAt(v, w); }
    [[nodiscard]] const float* line(int v, int w) const { return values.data() + lineAt(v, w); }

private:
    [[nodiscard]] std::size_t lineAt(int v, int w) const { return (static_cast<std::size_t>(w) * static_cast<std::size_t>(nv) + static_cast<std::size_t>(v)) * static_cast<std::size_t>(nu); }
};

/// What lightByFire() needs while it works; kept, so that its memory is allocated once.
struct FireWorkspace {
    /// A field at cells of one size, and on the way to those of twice that.
    struct Level {
        GridField glow; ///< radiance given off, 1/m of it
        GridField density; ///< extinction, 1/m
        GridField light;
        GridField halfU, halfV;
    };
    Appearance glowing; ///< of each particle what it gives off, as if that were its opacity
    AlignedArray<float> heat; ///< of each particle, as it glows
    std::vector<Level> levels;
};

/// Whether what glows lights the smoke around it.
[[nodiscard]] bool isLitByFire(const Light& light);

/// Lets what glows light the smoke: the mean radiance that reaches each cell from all particles, whatever their direction.
///
/// Particles give off brightness * alpha * pi r^2 / 3 over a cell's volume, j. What arrives at a distance r of that is exp(-tau) / (4 pi r^2),
/// and 1 / (4 pi r^2) = sqrt(pi / 2) * integral of s G_s(r) d(ln s) over all s, G_s the normalised Gaussian of deviation s: a sum over
/// octaves of s of blurred fields, each blurred on a grid as coarse as it is, and weakened by the smoke within s of the place. Light of one colour, the mean of what glows.
/// @param appearance as lightSmoke() was given it
/// @param light      what lightSmoke() has filled; gets fire and its colour
/// O(particles + cells). Sums have one order: the same bits for any thread count.
void lightByFire(const Frame& frame, const SampledEffect& effect, const Appearance& appearance, FireWorkspace& room, LightWorkspace& splats, LightGrid& light);

} // namespace fumage
