#pragma once

#include "core/base/task.h"
#include "core/base/result.h"
#include "core/lighting/appearance.h"
#include "core/rendering/renderer.h"
#include "core/simulation/scene_simulator.h"

#include <cstdint>
#include <vector>

namespace fumage {

/// Smoke as numbers in a box of cubic cells: x fastest, then y, then z. All boxes of cells of one size lie on one
/// lattice, which has the origin as a corner.
struct Volume {
    glm::ivec3 first{0}; ///< the cell at the corner of the box, on the lattice
    glm::ivec3 cells{0}; ///< none: there is no smoke
    float cell = 1.0F; ///< edge of one, m
    std::vector<float> density; ///< extinction, 1/m; 0: nothing is there, in all other columns as well
    std::vector<float> temperature; ///< mean heat of the smoke, 1 in the mean over the source, where source.unevenness
                                    ///< makes it vary; empty where the effect has neither air nor glow
    std::vector<float> flames; ///< extinction of what glows, weighted by the brightness of its glow, of the brightest
                               ///< 1; empty without glow
    std::vector<glm::vec3> velocity; ///< mean of the smoke, m/s of the film
    std::vector<std::vector<float>> layers; ///< the density of each layer, where it is asked for; their sum is that of
                                            ///< all, but for rounding
    bool hasTemperature = false; ///< the effect has such a column, be there smoke or not
    bool hasFlames = false;

    [[nodiscard]] std::size_t count() const { return density.size(); }
    /// Where the box begins, m.
    [[nodiscard]] glm::vec3 corner() const { return cell * glm::vec3(first); }
};

/// Fewest and most cells along the longest edge of the smoke of a timeline.
inline constexpr int kMinVolumeCells = 8;
inline constexpr int kMaxVolumeCells = 256;
/// Smallest and largest edge of a cell, m.
inline constexpr float kMinVoxel = 0.0001F;
inline constexpr float kMaxVoxel = 1000.0F;
/// Most cells of a box, 24 bytes each.
inline constexpr std::int64_t kMaxVolumeSize = std::int64_t{kMaxVolumeCells} * kMaxVolumeCells * kMaxVolumeCells;
/// Most numbers of a box with the densities of layers, a GiB.
inline constexpr std::int64_t kMaxVolumeNumbers = std::int64_t{1} << 28U;

/// Whether a volume has the density of each layer beside that of all.
enum class LayerDensities {
    No,
    Yes
};

/// What volumes have in every frame, whatever one shows: programs that read a sequence expect the same grids in all.
struct VolumeColumns {
    bool temperature = false;
    bool flames = false;
};
/// Those of layers: what glows at any time glows.
[[nodiscard]] VolumeColumns volumeColumns(SampledLayers layers);

/// Spreads the particles of a frame over cells.
///
/// Each is a ball of extinction 105 / (32 r) c alpha (1 - q^2)^2, q the distance from its centre over its radius r and
/// c what of a disc it covers (1/3 for the soft disc, see Coverage): seen from any side it takes c alpha pi r^2, as the
/// sprites and shadows of pictures do (see lightSmoke()). Shares are scaled so that each particle leaves all of it,
/// however small it is beside a cell.
/// @param voxel edge of a cell, kMinVoxel to kMaxVoxel, m
/// @error TooLarge before allocating, where the box around the smoke has more than kMaxVolumeSize cells
/// O(cells that particles cover). The same bits for any thread count and instruction set.
[[nodiscard]] Result<Volume> volumeOf(const Frame& frame, const SampledEffect& effect, float voxel);
/// The same of all layers together, with greysShown() of each found before.
/// @param columns that there are in any case; those of what glows in this frame as well
/// @error TooLarge also where the densities of layers are more than kMaxVolumeNumbers
[[nodiscard]] Result<Volume> volumeOf(LayerFrames layers, float voxel, std::span<const GreyCounts> greys,
    LayerDensities densities = LayerDensities::No, const VolumeColumns& columns = {});

/// The edge of cells, m, of which the smoke of a whole timeline has so many along the longest edge of the box around
/// it, rounded up to three digits: the same whichever frames are written, so that those of several programs fit
/// together. Of a timeline without smoke it is kVoxelWithoutSmoke.
/// @param simulator of the layers
/// @param longest   kMinVolumeCells to kMaxVolumeCells
/// @param task      hears of ProgressPhase::Fitting after each frame
/// @error those of SceneSimulator
/// O(frames of the timeline): each is simulated.
[[nodiscard]] Result<float> voxelFor(
    SceneSimulator& simulator, SampledLayers layers, int longest, const Task& task = {});
inline constexpr float kVoxelWithoutSmoke = 0.1F; // m

} // namespace fumage
