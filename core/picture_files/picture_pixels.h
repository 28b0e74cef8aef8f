#pragma once

#include "core/base/result.h"
#include "core/picture_files/picture_notes.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace fumage {

/// Most pixels of a picture that is read, and most numbers of all its channels.
inline constexpr std::size_t kMostReadPixels = std::size_t{1} << 26U;
inline constexpr std::size_t kMostReadNumbers = std::size_t{1} << 28U;

/// Straight RGBA of 16 bits, rows from the top: what 8 bits say times 257, grey in all three colours, and without alpha 65535.
struct RgbaPixels {
    int width = 0;
    int height = 0;
    std::vector<std::uint16_t> values;
};

/// The numbers of an EXR, rows from the top.
struct ExrNumbers {
    struct Channel {
        std::string name; ///< with that of its layer, as in "motion.X"
        std::vector<float> values;
    };
    int width = 0;
    int height = 0;
    std::vector<Channel> channels; ///< by name
};

/// What a picture shows, whatever its compression, notes and depth.
struct PictureHash {
    int width = 0;
    int height = 0;
    std::string hash; ///< SHA-256, see pictureHash()
};

/// Reads a PNG or a TGA, as encodeTga() makes them, to its very end; anybody may have made it.
/// @error Syntax: it is neither, or broken, or not whole; TooLarge
[[nodiscard]] Result<RgbaPixels> readPixels(std::span<const std::byte> file);

/// The SHA-256 of what a PNG, TGA or EXR shows. Of PNG and TGA: "rgba16 WIDTH HEIGHT\n", then RgbaPixels, the low byte first. Of EXR: "exr WIDTH HEIGHT\n",
/// then of each channel by name "NAME\n" and its numbers as 32-bit floats, the low byte first. So it stays the same where a file is compressed anew.
/// @error as readPixels()
[[nodiscard]] Result<PictureHash> pictureHash(std::span<const std::byte> file);
/// The same of a file that is read a part at a time: memory is bounded, but for an interlaced PNG and for TGA.
/// @error that of the reader
[[nodiscard]] Result<PictureHash> pictureHash(const PartReader& file);

} // namespace fumage
