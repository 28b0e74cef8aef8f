#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace fumage {

/// Longest edge of a picture in an effect, pixels, and most bytes of its file.
inline constexpr int kMaxPictureEdge = 512;
inline constexpr std::size_t kMaxPictureBytes = std::size_t{256} << 10U;

/// What to do where a picture is refused.
[[nodiscard]] Message pictureRemedy();

/// A picture that an effect holds, or none: a PNG as it was chosen, and its pixels. It never changes, and copies share
/// it, on any thread.
class Bitmap {
public:
    /// None.
    Bitmap() = default;

    /// Reads a PNG that anybody may have made. Its colours are taken as they are painted, whatever their colour space.
    /// @error Syntax: it is none, or broken, or not whole; TooLarge: longer than kMaxPictureBytes, or with an edge of
    /// more than kMaxPictureEdge; before any pixel is read
    /// O(pixels)
    [[nodiscard]] static Result<Bitmap> read(std::span<const std::byte> png);

    /// Whether there is none.
    [[nodiscard]] bool empty() const { return m_data == nullptr; }
    /// In pixels; 0 where there is none.
    [[nodiscard]] int width() const;
    [[nodiscard]] int height() const;
    /// Straight RGBA of 8 bits, height rows of width from the top.
    [[nodiscard]] std::span<const std::uint8_t> pixels() const;
    /// The bytes that it was read from.
    [[nodiscard]] std::span<const std::byte> file() const;

    /// Mean of its alpha over a square of its longer edge, 0 to 1; 0 where there is none.
    [[nodiscard]] float opacity() const;

    /// Whether any pixel is neither black nor transparent.
    [[nodiscard]] bool isBright() const;
    /// The pixel that a random number falls on, row by row from the top. The chance of each is its brightness times its
    /// alpha over the sum of all, in steps of 1/16383: luma of Rec. 709 of the colour as it is painted, so that half
    /// grey has half the chance of white. The same on every machine, since all of it is whole numbers.
    /// @param bits all values equally likely
    /// O(log pixels); isBright()
    [[nodiscard]] std::size_t brightPixel(std::uint32_t bits) const;
    /// How bright it is around a place, over the brightest place: 0 to 1, smooth, of a copy of kCover by kCover cells.
    /// @param across,down 0 to 1 from the left and the top; beyond, as at the border
    /// O(1); isBright()
    [[nodiscard]] float coverAt(float across, float down) const;
    static constexpr int kCover = 32;

    /// Whether both are read from the same bytes.
    friend bool operator==(const Bitmap& a, const Bitmap& b);

private:
    struct Data;

    std::shared_ptr<const Data> m_data;
};

} // namespace fumage
