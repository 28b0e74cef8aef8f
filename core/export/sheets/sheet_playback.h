#pragma once

#include "core/export/sheets/flipbook.h"

#include <cstdint>

namespace fumage {

/// How an engine goes from one cell to the next.
enum class CellBlending {
    None, ///< it shows one cell until the next one's time has come
    CrossFade, ///< it mixes them
    Motion, ///< it moves each along its vectors, and mixes what has been moved
};

/// A flipbook as an engine plays it, after Unity's VFXCommonOutput: with f the way from one cell to the next, s0 =
/// colour_i(uv - m_i(uv) f), s1 = colour_i+1(uv + m_i+1(uv) (1 - f)), their mixture by f. Colours are linear,
/// premultiplied and at most 1.
class SheetPlayback {
public:
    /// @param sheet must stay; has the target of the colour
    explicit SheetPlayback(const PassSheet& sheet)
        : m_sheet(sheet)
    {
    }
    /// The same with what the file of the vectors holds, as shares of a cell once it is multiplied by the scale.
    SheetPlayback(const PassSheet& sheet, DataImage motion, float scale)
        : m_sheet(sheet)
        , m_motion(std::move(motion))
        , m_scale(scale)
    {
    }

    [[nodiscard]] bool hasMotion() const { return !m_motion.values.empty(); }

    /// One pixel between two cells.
    /// @param f in [0, 1] @param blending Motion needs vectors
    [[nodiscard]] glm::vec4 pixel(int one, int other, float f, int x, int y, CellBlending blending) const;

    /// A whole picture, of a cell's size.
    /// @param cell 0 and more: 2.25 is a quarter of the way from the third cell to the fourth @param loops after the
    /// last cell comes the first; else the last one stays O(pixels of a cell), on all threads. Without vectors Motion
    /// is a cross-fade.
    void picture(double cell, bool loops, CellBlending blending, Image& out) const;

private:
    [[nodiscard]] glm::vec4 moved(const SheetCell& cell, int x, int y, float way) const;

    const PassSheet& m_sheet;
    DataImage m_motion;
    float m_scale = 1.0F;
};

/// What a flipbook's pictures take in a graphics card's memory, in bytes, without the smaller copies of mipmaps (a
/// third more).
struct SheetMemory {
    std::int64_t compressed = 0; ///< as BC7: 16 bytes for 4 x 4 pixels
    std::int64_t plain = 0; ///< 4 bytes a pixel, or as many more as the format has bits
};

/// @param pictures how many of them
[[nodiscard]] SheetMemory memoryOf(std::int64_t width, std::int64_t height, int pictures, ImageFormat format);
/// Of all pictures of a flipbook, packed ones at their own size; of layers that have sheets of their own all sheets.
/// Masks of layers take a picture for every four.
/// @param layers that are written, 1 or more
[[nodiscard]] SheetMemory memoryOf(
    const FlipbookOptions& options, int cellWidth, int cellHeight, std::size_t layers = 1);

} // namespace fumage
