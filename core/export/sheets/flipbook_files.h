#pragma once

#include "core/export/sheets/flipbook_options.h"
#include "core/scene/scene.h"

#include <filesystem>
#include <span>
#include <vector>

namespace fumage {

/// The file beside the picture of a flipbook that says how it is to be played.
[[nodiscard]] std::filesystem::path descriptionOf(const std::filesystem::path& picture);

/// Passes one by one, in their order.
[[nodiscard]] std::vector<Pass> listOf(PassSet passes);

/// The picture of a pass: the colour's has the name that was given, others have what they are before the ending, as in
/// smoke_sixway_a.png.
/// @param picture with its ending
[[nodiscard]] std::filesystem::path pictureOf(const std::filesystem::path& picture, Pass pass);

/// The sheets of a flipbook, each with a name of its own: one, or one a layer, as in smoke_flames.png.
[[nodiscard]] std::vector<FlipbookOptions> sheetsOf(const Scene& scene, const FlipbookOptions& options);
/// All files that a flipbook of a scene is made of: those of its sheets, one after the other, then what its engine
/// needs for all of them, where they are shares of one picture.
[[nodiscard]] std::vector<std::filesystem::path> filesOf(const Scene& scene, const FlipbookOptions& options);
/// What an engine needs to draw the sheets of layers over one another; empty: nothing.
[[nodiscard]] std::vector<std::filesystem::path> sharedFilesOf(
    const FlipbookOptions& options, std::span<const FlipbookOptions> sheets);
/// The files of one sheet: its pictures in the order of the passes, packed ones, what its engine needs for it alone,
/// then the description.
[[nodiscard]] std::vector<std::filesystem::path> filesOfSheet(const FlipbookOptions& sheet);
/// The pictures of one sheet.
[[nodiscard]] std::vector<std::filesystem::path> picturesOf(const FlipbookOptions& sheet);

} // namespace fumage
