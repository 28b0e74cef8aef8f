#pragma once

#include "core/export/engines/engine_sheet.h"
#include "core/export/sheets/flipbook_options.h"

#include <cstddef>
#include <stop_token>
#include <vector>

namespace fumage {

/// A file in memory.
using FileBytes = std::vector<std::byte>;

/// What the pictures of a sheet say beside their pixels.
[[nodiscard]] ImageMetadata notesOf(const FlipbookOptions& sheet);

/// The bytes of all pictures of a sheet in the order of picturesOf(), each on a thread of its own.
/// @param colour of the colour's picture, where it is made already; empty: it is made of the sheet
/// @error those of the encoders, with the file that they are of
[[nodiscard]] Result<std::vector<FileBytes>> encodePictures(const PassSheet& sheet, const PassPictures& pictures,
    const Scene& scene, const FlipbookOptions& options, FileBytes colour, const std::stop_token& stop);

/// What engines are told of a sheet with these pictures, or none; all must stay.
[[nodiscard]] EngineSheet engineSheet(const Scene& scene, const FlipbookOptions& options, const Flipbook& flipbook,
    const PassScales& scales, const std::vector<FileBytes>& bytes);

} // namespace fumage
