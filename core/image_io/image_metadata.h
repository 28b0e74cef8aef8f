#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace fumage {

/// What a picture says beside its pixels.
struct ImageMetadata {
    int frameRate = 0; ///< frames/s of the pictures that it is one of, in EXR; 0: not said
    std::string preset; ///< that it was made of, as JSON; empty: not said
    int frame = 0; ///< of the preset that it shows, the first of a sheet; only with a preset
    std::string sheet{}; ///< of a sheet: how its cells are made, see sheetNoteOf(); only with a preset
};

// Texts of PNG and attributes of EXR: EXR has 31 letters for a name.
inline constexpr std::string_view kPresetNote = "fumage:preset";
inline constexpr std::string_view kFrameNote = "fumage:frame";
inline constexpr std::string_view kSheetNote = "fumage:sheet";

/// Notes of an EXR stand within this much of its beginning; so much of a PNG is looked at, too, its pixels left out.
inline constexpr std::size_t kPictureHead = std::size_t{2} << 20U;
/// A preset that is longer, packed or not, is not read.
inline constexpr std::size_t kMaxNoteBytes = std::size_t{1} << 20U;

/// What a file is by its first bytes.
enum class PictureKind {
    None, ///< none that is known
    Png,
    Exr,
    Tga, ///< as encodeTga() makes it
};
[[nodiscard]] PictureKind kindOf(std::string_view head);

inline constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

/// Whether a file that begins with these bytes, eight or more, is a PNG, an EXR, or a TGA as encodeTga() makes it.
[[nodiscard]] bool isPicture(std::string_view head);

/// Reads a part of a file: less than its size where the file ends within it, nothing where it ends before.
using PartReader = std::function<Result<std::string>(std::uint64_t at, std::size_t size)>;

/// That of bytes in memory, which must stay.
[[nodiscard]] PartReader partsOf(std::string_view bytes);

/// What is said of a preset in a picture that cannot be read.
[[nodiscard]] Error damagedNote();

/// JSON with every letter beyond ASCII as \uXXXX, which means the same: what programs that know but Latin-1 leave as it
/// is.
[[nodiscard]] std::string asciiJson(std::string_view json);

} // namespace fumage
