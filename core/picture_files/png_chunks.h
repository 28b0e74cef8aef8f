#pragma once

#include "core/base/result.h"
#include "core/picture_files/picture_notes.h"

#include <string>

namespace fumage {

inline constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

/// A PNG without its pixels, and without texts that are not ours.
struct PngTexts {
    std::string file; ///< ends where the pixels would begin
    bool hasPreset = false; ///< whether there is a text that is to have a preset, be it damaged or too long to be here
};

/// Gathers our texts from before the pixels and, where there are none, from behind them: ImageMagick writes all texts
/// there.
/// @error Syntax: the file ends before its pixels; that of the reader
/// O(chunks up to the pixels, or up to kMostPngChunks of them), each a part of a few bytes.
[[nodiscard]] Result<PngTexts> textsOfPng(const PartReader& file);

} // namespace fumage
