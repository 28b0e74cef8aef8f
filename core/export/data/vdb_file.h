#pragma once

#include "core/export/export_task.h"
#include "core/export/sequence.h"
#include "core/export/data/up_axis.h"
#include "core/export/data/volume.h"
#include "core/scene/scene.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// A volume as the bytes of an OpenVDB file (format 224, half floats, not compressed): the grids density (1/m), vel
/// (m/s), and where the effect has such temperature and flames, be there smoke or not. Fog volumes of trees of 32, 16
/// and 8 cells; voxels without smoke are not there.
///
/// After the sources of OpenVDB 10 and "VDB: A Deep Dive", JangaFX 2022. Written here rather than by the library: that
/// would be 55 MB beside a program that starts in a blink, and its bytes change with its version; ours are the same
/// everywhere.
/// @param up     axis that points up: y, or z as Blender has it
/// @param layers names of the grids of layers, which stand in place of density; as many as the volume has, or none
[[nodiscard]] std::string encodeVdb(const Volume& volume, UpAxis up, std::span<const std::string> layers = {});

/// Which grids of density a volume has.
enum class DensityGrids {
    Together, ///< one of all layers
    Layers, ///< one a layer
};
inline constexpr std::size_t kDensityGrids = 2;
/// "together", "layers".
[[nodiscard]] std::string_view nameOf(DensityGrids grids);

/// The names of the grids of layers, in the order of writtenLayers(): density_flames. They have small letters, digits
/// and _ alone, as every program takes them, and none is twice there.
[[nodiscard]] std::vector<std::string> namesOfGrids(const Scene& scene);

/// That of the files.
inline constexpr std::string_view kVdbEnding = ".vdb";

struct VolumeSequenceOptions {
    std::filesystem::path output; ///< ## becomes the frame number; see framePath()
    FrameRange frames;
    /// Cells along the longest edge of the smoke of the whole timeline, kMinVolumeCells to kMaxVolumeCells
    int longest = 128;
    /// Edge of a cell, kMinVoxel to kMaxVoxel, m, in place of the one that longest comes to
    std::optional<float> voxel;
    UpAxis up = UpAxis::Z;
    DensityGrids density = DensityGrids::Together;
    std::filesystem::path source; ///< the preset's file, which is not to be overwritten; empty where it has none
    FrameSink written{}; ///< hears of each file that is in its place, if there is anybody
};

/// Writes the smoke of frames into numbered files, each whole or not at all. All have the same grids and one lattice,
/// which depends on the effect and the voxel alone: parts of a range that are written apart fit together.
/// @param task hears of ProgressPhase::Fitting while the voxel is looked for, then of ProgressPhase::Frames after each
/// @return the edge of a voxel, m
/// @error OutOfRange; TooLarge; WouldOverwrite; that of the first frame that fails: files before it stay
[[nodiscard]] Result<float> writeVolumes(
    const Scene& scene, const VolumeSequenceOptions& options, const ExportTask& task = {});

} // namespace fumage
