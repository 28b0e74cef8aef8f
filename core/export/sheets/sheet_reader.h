#pragma once

#include "core/export/sheets/sheet_preview.h"

#include <filesystem>

namespace fumage {

/// Reads a flipbook back from its files, as an engine has it: the colours, and the motion vectors where there are any.
/// @param description the file that says how it is played; the pictures lie beside it. Anybody may have made them
/// @param mostPixels  of the sheet
/// @return the whole sheet, premultiplied and linear, shown without exposure and view transform
/// @error those of readFile(), parseJson() and readPixels(); WrongType, WrongVersion, OutOfRange: it is no description
/// of a flipbook, or its pictures are others than it says; TooLarge before the pixels are allocated
/// On the calling thread. O(pixels).
[[nodiscard]] Result<std::shared_ptr<const SheetPreview>> readFlipbook(
    const std::filesystem::path& description, std::int64_t mostPixels);

} // namespace fumage
