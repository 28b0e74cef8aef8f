#pragma once

#include "core/export/sheets/flipbook_options.h"

#include <filesystem>
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

/// All files that a flipbook is made of: its pictures in the order of the passes, packed ones, what its engine needs,
/// then the description.
[[nodiscard]] std::vector<std::filesystem::path> filesOf(const FlipbookOptions& options);
/// The pictures alone.
[[nodiscard]] std::vector<std::filesystem::path> picturesOf(const FlipbookOptions& options);

} // namespace fumage
