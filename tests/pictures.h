#pragma once

#include "core/effect/bitmap.h"
#include "core/image_io/png_file.h"

#include <array>
#include <functional>
#include <vector>

#include <QtTest/QtTest>

namespace fumage::tests {

/// The bytes of a PNG of 8 bits.
/// @param colour straight RGBA of a pixel, from the left and the top
inline std::vector<std::byte> pngOf(
    int width, int height, const std::function<std::array<std::uint8_t, 4>(int x, int y)>& colour)
{
    std::vector<std::byte> bytes;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (const std::uint8_t channel : colour(x, y)) {
                bytes.push_back(static_cast<std::byte>(channel));
            }
        }
    }
    return encodePng({.width = width, .height = height, .bytes = bytes}).value();
}

inline Bitmap pictureOf(int width, int height, const std::function<std::array<std::uint8_t, 4>(int x, int y)>& colour)
{
    const Result<Bitmap> picture = Bitmap::read(pngOf(width, height, colour));
    if (!picture) {
        qFatal("%s", picture.error().text().c_str());
    }
    return picture.value();
}

/// Opaque, and brighter to the right.
inline Bitmap ramp(int width, int height)
{
    return pictureOf(width, height, [width](int x, int /*y*/) {
        const auto grey = static_cast<std::uint8_t>(255 * (x + 1) / width);
        return std::array<std::uint8_t, 4>{grey, grey, grey, 255};
    });
}

/// A picture that no compression makes smaller.
inline Bitmap incompressible(int edge, std::uint32_t seed)
{
    std::uint32_t bits = seed;
    return pictureOf(edge, edge, [&](int /*x*/, int /*y*/) {
        bits = bits * 1664525U + 1013904223U;
        return std::array<std::uint8_t, 4>{static_cast<std::uint8_t>(bits >> 24U),
            static_cast<std::uint8_t>(bits >> 16U), static_cast<std::uint8_t>(bits >> 8U),
            static_cast<std::uint8_t>(seed)};
    });
}

} // namespace fumage::tests
