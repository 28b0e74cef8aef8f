#pragma once

#include "core/base/result.h"
#include "core/image_io/pixel_arrays.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace fumage {

/// Rows of a picture in memory, from the top, channels side by side, 8 bits each.
struct TgaPixels {
    int width = 0; ///< 1..65535, as many as its header can say
    int height = 0;
    int channels = 4; ///< 1 grey, 3 RGB, 4 RGBA with straight alpha
    std::span<const std::uint8_t> bytes; ///< width * height * channels
};

/// Encodes a picture as TGA: BGRA, BGR or grey, the first pixel at the top left; colours in runs that end with their
/// row, grey plainly, since Unreal reads no runs of grey. It holds no colour space, and no notes: what readers keep of
/// its text fields is little. Source: Truevision, "TGA File Format Specification", version 2.0, 1991. O(pixels).
[[nodiscard]] std::vector<std::byte> encodeTga(const TgaPixels& pixels);

/// readPixels() of a TGA as encodeTga() makes it. O(pixels).
[[nodiscard]] Result<RgbaPixels> readTga(std::span<const std::byte> file);

} // namespace fumage
