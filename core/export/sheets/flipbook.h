#pragma once

#include "core/base/task.h"
#include "core/export/export_task.h"
#include "core/export/frame_source.h"
#include "core/export/sheets/flipbook_options.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace fumage {

/// Renders frames into one picture of columns by rows cells, each of effect.output's size, first at the top left, then
/// along the rows, as Unity, Unreal, Godot and Effekseer read them. PNG: straight alpha in which transparent pixels
/// have the colour of the smoke next to them, so that filtering and mipmaps bring no dark rims. Other passes are
/// pictures of their own beside it, linear and without view transform. NAME.flipbook.json says how it is to be played
/// (not NAME.json, which may be a preset). What makes an engine play it lies beside it, too. All are written whole or
/// not at all.
/// @error TooLarge before allocating, OutOfRange, those of checkEngine(), checkPacks() and renderSequence()
[[nodiscard]] Result<Flipbook> renderFlipbook(
    const Scene& scene, const FlipbookOptions& options, const ExportTask& task = {});

/// A file of a flipbook, not written.
struct FlipbookFile {
    std::filesystem::path path;
    std::vector<std::byte> bytes;
};

/// The files that renderFlipbook() writes, in the order of filesOf(); nothing is written.
/// @error those of renderFlipbook()
[[nodiscard]] Result<std::vector<FlipbookFile>> encodeFlipbook(
    const Scene& scene, const FlipbookOptions& options, const ExportTask& task = {});

/// renderFlipbook() of frames that are there already. Nothing is known of smoke that is cut off.
/// @param options whose only pass is the colour
/// @error OutOfRange where other passes are asked for; those of renderFlipbook() and of the frames
[[nodiscard]] Result<Flipbook> joinFlipbook(
    const Scene& scene, const FlipbookOptions& options, const FrameSource& frames, const Task& task = {});

} // namespace fumage
