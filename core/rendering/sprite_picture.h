#pragma once

#include "core/base/aligned_array.h"
#include "core/effect/bitmap.h"

#include <bit>
#include <cstddef>
#include <vector>

namespace fumage {

/// A picture as sprites read it: premultiplied linear light in several resolutions, on a square that its longer edge
/// fills; beside its shorter one that is transparent. Of each level the mean alpha is Bitmap::opacity().
class SpritePicture {
public:
    static constexpr int kMaxLevels = std::bit_width(static_cast<unsigned>(kMaxPictureEdge));
    static constexpr std::size_t kChannels = 4; ///< of a texel, red to alpha

    /// @param bitmap not empty
    /// O(pixels)
    explicit SpritePicture(const Bitmap& bitmap);

    /// Resolutions, each half of the one before, down to one texel.
    [[nodiscard]] int levels() const { return static_cast<int>(m_levels.size()); }
    /// Texels along an edge of a level, 0 the finest: a power of two.
    [[nodiscard]] int levelSize(int level) const { return m_size >> level; }
    /// @return levelSize^2 texels of kChannels floats, rows from the top
    [[nodiscard]] const float* texels(int level) const { return m_levels[static_cast<std::size_t>(level)].data(); }

    /// Texels along an edge of the finest level for a picture: its longer edge, rounded up to a power of two.
    [[nodiscard]] static int sizeFor(const Bitmap& bitmap);

private:
    int m_size;
    std::vector<AlignedArray<float>> m_levels;
};

} // namespace fumage
