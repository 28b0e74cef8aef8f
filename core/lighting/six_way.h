#pragma once

#include "core/lighting/light_grid.h"

#include <array>

namespace fumage {

/// White light along the axes of a frame of reference, one at a time: from +u, +v and +w, and from -u, -v and -w, as
/// light maps for six directions hold it.
struct SixWayLight {
    static constexpr std::size_t kDirections = 6;
    static constexpr std::size_t kStride = 4;

    LightGrid grid; ///< shape and density; its light is not used
    AlignedArray<float> fromAbove; ///< kStride floats a cell: light from +u, +v, +w, and one that is not looked at
    AlignedArray<float> fromBelow; ///< the same from -u, -v, -w
    /// What is left of them, and then scattered many times: as above, where light.multiple_scattering asks for it.
    AlignedArray<float> diffuseAbove, diffuseBelow;
    std::array<AlignedArray<float>, kDirections> single; ///< one float a cell while the directions are gone through
};

/// Lets light of intensity 1 through the smoke along both directions of each axis: as lightSmoke() does with a sun
/// there, but for cells that are those of one grid for all of them, so that the particles are splatted once.
/// @param layers with bounds in these axes
/// @param eye    the camera, m
/// O(particles + cells). The same bits for any thread count and instruction set.
void lightSixWays(LitLayers layers, const Axes& axes, const glm::vec3& eye, LightWorkspace& room, SixWayLight& out);

} // namespace fumage
