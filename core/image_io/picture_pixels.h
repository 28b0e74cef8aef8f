#pragma once

#include "core/base/result.h"
#include "core/image_io/image_metadata.h"
#include "core/image_io/pixel_arrays.h"

#include <cstddef>
#include <span>
#include <string>

namespace fumage {

/// What a picture shows, whatever its compression, notes and depth.
struct PictureHash {
    int width = 0;
    int height = 0;
    std::string hash; ///< SHA-256, see pictureHash()
};

/// Reads a PNG or a TGA, as encodeTga() makes them, to its very end; anybody may have made it.
/// @error Syntax: it is neither, or broken, or not whole; TooLarge
[[nodiscard]] Result<RgbaPixels> readPixels(std::span<const std::byte> file);

/// The SHA-256 of what a PNG, TGA or EXR shows. Of PNG and TGA: "rgba16 WIDTH HEIGHT\n", then RgbaPixels, the low byte
/// first. Of EXR: "exr WIDTH HEIGHT\n", then of each channel by name "NAME\n" and its numbers as 32-bit floats, the low
/// byte first. So it stays the same where a file is compressed anew.
/// @error as readPixels()
[[nodiscard]] Result<PictureHash> pictureHash(std::span<const std::byte> file);
/// The same of a file that is read a part at a time: memory is bounded, but for an interlaced PNG and for TGA.
/// @error that of the reader
[[nodiscard]] Result<PictureHash> pictureHash(const PartReader& file);

} // namespace fumage
