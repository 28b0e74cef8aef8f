#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <span>
#include <stop_token>
#include <vector>

namespace fumage {

/// A picture in memory for OpenEXR: interleaved floats, rows from the top.
struct ExrPixels {
    int width = 0;
    int height = 0;
    int channels = 4; ///< 1: Y; 3: R, G, B; 4: R, G, B, A
    bool half = true; ///< else 32-bit floats
    std::span<const float> values;
    int frameRate = 0; ///< frames/s of the pictures that it is one of; 0: not said
    bool isLight = true; ///< premultiplied colours; else numbers that have no primaries
};

/// @error WriteFailed, Cancelled
[[nodiscard]] Result<std::vector<std::byte>> encodeExr(const ExrPixels& pixels, const std::stop_token& stop = {});

} // namespace fumage
