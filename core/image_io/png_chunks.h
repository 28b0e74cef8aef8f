#pragma once

#include "core/base/result.h"
#include "core/image_io/image_metadata.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace fumage {

/// A PNG without its pixels, and without texts that are not ours.
struct PngTexts {
    std::string file; ///< ends where the pixels would begin
    bool hasPreset = false; ///< whether there is a text that is to have a preset, be it damaged or too long to be here
};

/// Gathers our texts from before the pixels and, where there are none, from behind them: ImageMagick writes all texts
/// there.
/// @error Syntax: the file ends before its pixels; that of the reader
/// O(chunks up to the pixels, or up to kMaxPngChunks of them), each a part of a few bytes.
[[nodiscard]] Result<PngTexts> textsOfPng(const PartReader& file);

/// A PNG as it is where it carries no preset: without our texts of that. What is no PNG, or broken, stays from there
/// on. O(bytes).
[[nodiscard]] std::vector<std::byte> withoutNotes(std::span<const std::byte> png);

} // namespace fumage
