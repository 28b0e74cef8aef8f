#pragma once

#include "core/export/data/air_file.h"
#include "core/export/sheets/flipbook.h"
#include "core/export/manifest/recorded.h"
#include "core/export/data/particle_dump.h"
#include "core/export/data/vdb_file.h"
#include "core/export/video/video.h"
#include "core/preset/preset.h"

#include <optional>

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

/// All that decides what an export writes, but for the effect.
struct ExportPlan {
    ExportKind kind = ExportKind::Sequence;
    std::filesystem::path output; ///< of numbered files: ## stands for the frame number, a missing ending is added;
                                  ///< else the file as it is named
    FrameRange frames; ///< of one picture: the first
    ImageFormat format = ImageFormat::Png8;
    VideoFormat video = VideoFormat::Mp4;
    Repeat repeat = Repeat::Auto; ///< of a video that says how often it is played
    std::optional<FrameRate> rate; ///< of a video, at which the timeline's frames are played; none: the timeline's
    ParticleFormat particles = ParticleFormat::Csv;
    AirFormat air = AirFormat::Fga;
    int cells = VolumeSequenceOptions().longest; ///< of volumes, along the longest edge of the smoke of the timeline,
                                                 ///< kMinVolumeCells to kMaxVolumeCells
    std::optional<float>
        voxel; ///< of volumes, the edge of a cell, m, in place of the one that cells come to; kMinVoxel to kMaxVoxel
    std::optional<UpAxis> up; ///< of volumes, and of particles in a format that has no axes of its own; none: z for
                              ///< volumes, as Blender has it, else y
    int columns = 8; ///< of a flipbook, 1..kMaxSheetCells
    int rows = 8;
    PassSet passes{Pass::Colour}; ///< of a flipbook, and of frames in EXR
    PassStyle style; ///< of its passes
    std::vector<PackedPicture> packs; ///< of a flipbook: more pictures
    Engine engine = Engine::Generic; ///< that is to play it
    bool trim = false; ///< of a flipbook: empty frames at the beginning and the end are left out; see trimmed()
    std::optional<Curve> retime; ///< of a flipbook; see FlipbookOptions
    bool powerOfTwo = false; ///< of a flipbook: the size of cells is such that the sides of the sheet are powers of two
    int noiseSize = 0; ///< edge of the tile in pixels, to kMaxTextureSize; 0: the effect's own
    bool fitCamera = false; ///< pictures are taken by the camera that fitCamera() finds for their frames; those who
                            ///< render an animation in parts fit it before
    float noiseDepth = 0.0F; ///< where the third axis of the noise is cut, 0 to 1
    std::optional<Preset> project; ///< that pictures carry, so that they open as it, with the effect that they show in
                                   ///< place of its own; none: they carry nothing
    Recording recording; ///< of frames and flipbooks
    std::filesystem::path source; ///< the preset's file, which is not to be overwritten; empty where it has none
};

/// The ending of the files that a plan writes, with its dot.
[[nodiscard]] std::string_view fileEnding(const ExportPlan& plan);

/// All files that a plan writes, in their order; what describes a flipbook, and what its engine needs, among them.
/// O(files).
[[nodiscard]] std::vector<std::filesystem::path> filesOf(const ExportPlan& plan);
/// The files of a plan, first and last; what describes a flipbook lies beside it.
[[nodiscard]] std::filesystem::path firstFile(const ExportPlan& plan);
[[nodiscard]] std::filesystem::path lastFile(const ExportPlan& plan);
/// Whether a manifest can be written of a plan of this kind: frames and flipbooks.
[[nodiscard]] bool canBeRecorded(ExportKind kind);
/// The manifest, or the part of one, that a plan writes beside its files; empty: none. What is there already is
/// replaced with them.
[[nodiscard]] std::filesystem::path manifestOf(const ExportPlan& plan);

/// What a plan for a flipbook asks for, with all of its frames.
[[nodiscard]] FlipbookOptions flipbookOf(const ExportPlan& plan);

/// What a plan for a video asks for.
[[nodiscard]] VideoOptions videoOf(const ExportPlan& plan);

/// The output of an effect with the size of the pictures, or cells, of a plan: for powers of two the nearest, by their
/// ratio.
/// @error OutOfRange where columns and rows make that impossible
[[nodiscard]] Result<Output> outputFor(const Effect& effect, const ExportPlan& plan);

/// The effect as the camera of a plan sees it, which is fitted where that is asked for.
/// @error those of fitCamera() and outputFor()
[[nodiscard]] Result<Effect> effectSeenBy(
    const Effect& effect, const ExportPlan& plan, const Progress& progress, const std::stop_token& stop = {});

/// The flipbook of a plan with the frames that it is made of: those without smoke at the beginning and the end are left
/// out where that is asked for.
/// @param seen effectSeenBy()
/// @error those of trimmed()
[[nodiscard]] Result<FlipbookOptions> flipbookSeenBy(
    const Effect& seen, const ExportPlan& plan, const Progress& progress, const std::stop_token& stop = {});

/// Writes all that a plan says, each file whole or not at all. On the calling thread.
/// @param progress hears of each picture of a sequence and each cell of a flipbook; before them, of each frame that a
/// fit of the camera looked at
/// @return         the flipbook, where that is what was made
/// @error          WouldOverwrite where a file that the plan names is the source; those of fitCamera(),
/// renderSequence(), renderFlipbook(), bakeNoise(), dumpSequence(), writeVolumes(), writeAir(), writeFileAtomically(),
/// and OutOfMemory
[[nodiscard]] Result<std::optional<Flipbook>> runExport(
    const Effect& effect, const ExportPlan& plan, const Progress& progress, const std::stop_token& stop = {});

/// The bytes of the one file of a plan, without writing it.
/// @error OutOfRange where there are several files; those of runExport()
[[nodiscard]] Result<std::vector<std::byte>> exportBytes(
    const Effect& effect, const ExportPlan& plan, const std::stop_token& stop = {}, const Progress& progress = {});

} // namespace fumage
