#pragma once

#include "core/base/aligned_array.h"

#include <stop_token>

#include <glm/vec4.hpp>

namespace fumage {

/// A picture in linear light: premultiplied RGBA floats, row-major, origin top-left.
struct Image {
    int width = 0;
    int height = 0;
    RawArray<float> pixels; ///< width * height * 4

    /// Makes room; what the pixels hold then is undefined.
    void resize(int newWidth, int newHeight)
    {
        width = newWidth;
        height = newHeight;
        pixels.resize(static_cast<std::size_t>(newWidth) * static_cast<std::size_t>(newHeight) * 4);
    }

    /// The first pixel of a row; y in [0, height), 0 on top.
    [[nodiscard]] float* row(int y)
    {
        return pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width) * 4;
    }
    /// As above.
    [[nodiscard]] const float* row(int y) const
    {
        return pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width) * 4;
    }
    /// One pixel, premultiplied.
    [[nodiscard]] glm::vec4 at(int x, int y) const
    {
        const float* p = row(y) + static_cast<std::size_t>(x) * 4;
        return {p[0], p[1], p[2], p[3]};
    }
};

/// Averages blocks of factor by factor pixels.
/// @param image its edges are multiples of factor
/// @param stop  ends it early, with rows that hold nothing
[[nodiscard]] Image downsample(const Image& image, int factor, const std::stop_token& stop = {});

} // namespace fumage
