#pragma once

#include "core/base/result.h"
#include "core/image_io/image_metadata.h"
#include "core/image_io/pixel_arrays.h"
#include "core/image_io/png_chunks.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

namespace fumage {

/// Rows of a picture in memory for libpng.
struct PngPixels {
    int width = 0;
    int height = 0;
    int channels = 4; ///< 1 grey, 3 RGB, 4 RGBA with straight alpha
    int bits = 8; ///< 8 or 16; 16 in the byte order of this machine
    bool srgb = true; ///< the values are sRGB; else plain data: no colour space, and a comment that says so
    std::span<const std::byte> bytes;
    bool quick = false; ///< a third of the time, for a file a few per cent larger
    ImageMetadata notes{};
};

/// @error WriteFailed, Cancelled
[[nodiscard]] Result<std::vector<std::byte>> encodePng(const PngPixels& pixels, const std::stop_token& stop = {});

/// readImageMetadata() of a PNG.
[[nodiscard]] Result<ImageMetadata> readPngNotes(const PngTexts& texts);

/// Reads a PNG to its end, row by row as they come, so that memory is bounded; only of one that is interlaced are all
/// rows kept until then.
/// @param begin told width and height before the first row
/// @param row   straight RGBA of 16 bits, see RgbaPixels
/// @error as readPixels(); that of the reader
[[nodiscard]] Status readPngRows(const PartReader& file, const std::function<void(int width, int height)>& begin,
    const std::function<void(std::span<const std::uint16_t> row)>& row);

/// readPixels() of a PNG.
[[nodiscard]] Result<RgbaPixels> readPng(std::span<const std::byte> file);

} // namespace fumage
