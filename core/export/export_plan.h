#pragma once

#include "core/export/data/air_file.h"
#include "core/export/data/particle_dump.h"
#include "core/export/data/vdb_file.h"
#include "core/export/manifest/recording.h"
#include "core/export/sheets/flipbook_options.h"
#include "core/export/video/video.h"
#include "core/preset/preset.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace fumage {

/// What can be written.
enum class ExportKind {
    Sequence, ///< a picture for every frame of a range
    Flipbook, ///< frames of a range side by side in one picture
    Video, ///< frames of a range as a film
    Picture, ///< one frame
    NoiseTexture, ///< one tile, as particles read it
    Particles, ///< where they are, a file for every frame of a range
    Volumes, ///< the smoke in cells, a file for every frame of a range
    Air, ///< the velocities of the air, a file for every frame of a range
};

inline constexpr std::size_t kExportKinds = 8;

/// "sequence", "flipbook", "video", "picture", "noise", "particles", "volumes" or "air": what lists of jobs call it.
[[nodiscard]] std::string_view nameOf(ExportKind kind);

/// Whether it shows the smoke.
[[nodiscard]] bool isPicture(ExportKind kind);

/// Whether its files have an ImageFormat.
[[nodiscard]] bool isImage(ExportKind kind);

/// Whether it has a file for every frame of a range.
[[nodiscard]] bool isNumbered(ExportKind kind);

/// Of a flipbook.
struct FlipbookPlan {
    int columns = 8; ///< 1..kMaxSheetCells
    int rows = 8;
    Engine engine = Engine::Generic; ///< that is to play it
    std::vector<PackedPicture> packs; ///< more pictures
    bool trim = false; ///< empty frames at the beginning and the end are left out; see trimmed()
    std::optional<Curve> retime; ///< see FlipbookOptions
    bool powerOfTwo = false; ///< the size of cells is such that the sides of the sheet are powers of two
};

/// Of a video.
struct VideoPlan {
    VideoFormat format = VideoFormat::Mp4;
    Repeat repeat = Repeat::Auto; ///< of one that says how often it is played
    std::optional<FrameRate> rate; ///< at which the timeline's frames are played; none: the timeline's
};

/// Of volumes.
struct VolumePlan {
    int cells = VolumeSequenceOptions().longest; ///< along the longest edge of the smoke of the timeline,
                                                 ///< kMinVolumeCells to kMaxVolumeCells
    std::optional<float> voxel; ///< edge of a cell, m, in place of the one that cells come to; kMinVoxel to kMaxVoxel
    DensityGrids density = DensityGrids::Together;
};

/// Of the noise texture.
struct NoisePlan {
    int size = 0; ///< edge of the tile in pixels, to kMaxTextureSize; 0: the effect's own
    float depth = 0.0F; ///< where the third axis of the noise is cut, 0 to 1
};

/// All that decides what an export writes, but for the effect. What belongs to one kind is kept while there is another.
struct ExportPlan {
    ExportKind kind = ExportKind::Sequence;
    std::filesystem::path output; ///< of numbered files: ## stands for the frame number, a missing ending is added;
                                  ///< else the file as it is named
    FrameRange frames; ///< of one picture: the first
    ImageFormat format = ImageFormat::Png8;
    PassSet passes{Pass::Colour}; ///< of a flipbook, and of frames in EXR
    PassStyle style; ///< of its passes
    std::optional<LayerOutput> layers; ///< of flipbooks; none: together
    std::optional<BlendSpace> blending; ///< see FlipbookOptions
    FlipbookPlan flipbook;
    VideoPlan video;
    VolumePlan volume;
    NoisePlan noise;
    ParticleFormat particles = ParticleFormat::Csv;
    AirFormat air = AirFormat::Fga;
    std::optional<UpAxis> up; ///< of volumes, and of particles in a format that has no axes of its own; none: z for
                              ///< volumes, as Blender has it, else y
    bool fitCamera = false; ///< pictures are taken by the camera that fitCamera() finds for their frames; those who
                            ///< render an animation in parts fit it before
    float outlierPercent = 0.0F; ///< of the smoke, which such a camera may leave outside; see fitCamera()
    std::optional<Preset> project; ///< that pictures carry, so that they open as it, with the effect that they show in
                                   ///< place of its own; none: they carry nothing
    Recording recording; ///< of frames and flipbooks
    std::filesystem::path source; ///< the preset's file, which is not to be overwritten; empty where it has none
};

/// The ending of the files that a plan writes, with its dot.
[[nodiscard]] std::string_view fileEnding(const ExportPlan& plan);

/// Whether a manifest can be written of a plan of this kind: frames and flipbooks.
[[nodiscard]] bool canBeRecorded(ExportKind kind);
/// What a plan for a flipbook asks for, with all of its frames.
[[nodiscard]] FlipbookOptions flipbookOf(const ExportPlan& plan);

/// What a plan for a video asks for.
[[nodiscard]] VideoOptions videoOf(const ExportPlan& plan);

} // namespace fumage
