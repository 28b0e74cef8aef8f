#pragma once

#include "core/base/progress.h"
#include "core/lighting/appearance.h"

#include <stop_token>
#include <vector>

namespace fumage {

/// Smoke as numbers in a box of cubic cells: x fastest, then y, then z.
struct Volume {
    glm::ivec3 cells{0};
    float cell = 1.0F; ///< edge of one, m
    glm::vec3 corner{0.0F}; ///< where the box begins, m
    std::vector<float> density; ///< extinction, 1/m; 0: nothing is there, in all other columns as well
    std::vector<float> temperature; ///< mean heat of the smoke, 1 in the mean over the source, where air.unevenness makes it vary; empty where neither air nor glow knows any
    std::vector<float> flames; ///< extinction of what glows, weighted by the brightness of its glow, of the brightest 1; empty without glow
    std::vector<glm::vec3> velocity; ///< mean of the smoke, m/s

    [[nodiscard]] std::size_t count() const { return density.size(); }
};

/// Fewest and most cells along the longest edge.
inline constexpr int kMinVolumeCells = 8;
inline constexpr int kMaxVolumeCells = 256;

/// Spreads the particles of a frame over cells.
///
/// Each is a ball of extinction 105 / (32 r) c alpha (1 - q^2)^2, q the distance from its centre over its radius r and c what of a disc it covers (1/3 for the
/// soft disc, see Coverage): seen from any side it takes c alpha pi r^2, as the sprites and shadows of pictures do (see lightSmoke()). Shares are scaled so that
/// each particle leaves all of it, however small it is beside a cell.
/// @param longest cells along the longest edge of the box around the smoke
/// @param greys   of the texture that particles show; without any it is as if there were no texture
/// O(cells that particles cover). The same bits for any thread count and instruction set.
[[nodiscard]] Volume volumeOf(const Frame& frame, const SampledEffect& effect, int longest, const GreyCounts& greys = {});

} // namespace fumage
