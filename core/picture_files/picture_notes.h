#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace fumage {

/// What a picture says beside its pixels.
struct PictureNotes {
    int frameRate = 0; ///< frames/s of the pictures that it is one of, in EXR; 0: not said
    std::string preset; ///< that it was made of, as JSON; empty: not said
    int frame = 0; ///< of the preset that it shows, the first of a sheet; only with a preset
};

// Texts of PNG and attributes of EXR: EXR has 31 letters for a name.
inline constexpr std::string_view kPresetNote = "fumage:preset";
inline constexpr std::string_view kFrameNote = "fumage:frame";

/// Notes stand before the pixels: this much of a file is enough for readPictureNotes().
inline constexpr std::size_t kPictureHead = std::size_t{2} << 20U;
/// A preset that is longer, packed or not, is not read.
inline constexpr std::size_t kMostNoteBytes = std::size_t{1} << 20U;

/// What a file is by its first bytes.
enum class PictureKind {
    None, ///< none that is known
    Png,
    Exr,
    Tga, ///< as encodeTga() makes it
};
[[nodiscard]] PictureKind kindOf(std::string_view head);

/// Whether a file that begins with these bytes, eight or more, is a PNG, an EXR, or a TGA as encodeTga() makes it.
[[nodiscard]] bool isPicture(std::string_view head);

/// Reads the notes of a picture that anybody may have made; no pixel is looked at. O(head + kMostNoteBytes).
/// @param head the first bytes of the file: all of them, or kPictureHead
/// @return     preset and frame; without a preset where the picture carries none, as TGA never does, or one that is damaged
/// @error      Syntax: it is none of them, or broken before its pixels
[[nodiscard]] Result<PictureNotes> readPictureNotes(std::string_view head);

} // namespace fumage
