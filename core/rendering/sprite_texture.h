#pragma once

#include "core/base/aligned_array.h"
#include "core/base/result.h"
#include "core/effect/effect.h"
#include "core/lighting/coverage.h"

#include <array>
#include <bit>
#include <cstdint>
#include <stop_token>
#include <vector>

namespace fumage {

/// The noise texture as sprites read it: slices of 3D noise, each in several resolutions, in 8 bits.
///
/// Every texel holds its own value and those of its neighbours to the right, above and both, one byte each from the
/// lowest: one 32-bit read gives all that bilinear interpolation needs. Slices repeat in x, y and depth.
class SpriteTexture {
public:
    /// Coarsest level: 4 x 4 texels.
    static constexpr int kSmallest = 4;
    static constexpr int kMaxLevels = std::bit_width(static_cast<unsigned>(kMaxNoiseResolution / kSmallest));

    /// @error Cancelled
    [[nodiscard]] static Result<SpriteTexture> bake(const Noise& noise, const std::stop_token& stop = {});

    /// Builds the levels from slices that are already baked.
    /// @param slices each size * size values in [0, 1]; size a power of two, kSmallest or more
    [[nodiscard]] static SpriteTexture pack(int size, const std::vector<AlignedArray<float>>& slices);

    /// Texels along an edge of the finest level.
    [[nodiscard]] int size() const { return m_size; }
    /// Slices in depth; 1 for 2D noise.
    [[nodiscard]] int slices() const { return m_slices; }
    /// Resolutions, each half of the one before.
    [[nodiscard]] int levels() const { return static_cast<int>(m_levels.size()); }
    /// Texels along an edge of a level, 0 the finest.
    [[nodiscard]] int levelSize(int level) const { return m_size >> level; }

    /// @return levelSize^2 texels, row-major
    [[nodiscard]] const std::uint32_t* texels(int level, int slice) const
    {
        const auto edge = static_cast<std::size_t>(levelSize(level));
        return m_levels[static_cast<std::size_t>(level)].data() + static_cast<std::size_t>(slice) * edge * edge;
    }

    /// The greys that sprites show of a level between its texels; of the texels themselves where level is levels():
    /// sprites too small for a texture show one of the coarsest.
    [[nodiscard]] const GreyCounts& greys(int level) const { return m_greys[static_cast<std::size_t>(level)]; }

private:
    SpriteTexture(int size, int slices);
    void packSlice(int slice, AlignedArray<float> values);
    void countGreys();

    std::vector<GreyCounts> m_greys;
    int m_size = 0;
    int m_slices = 0;
    std::vector<AlignedArray<std::uint32_t>> m_levels;
};

/// The greys that sprites of an effect show, for what they cover; none are counted where they show no texture.
/// @error Cancelled
/// As SpriteTexture::bake().
[[nodiscard]] Result<GreyCounts> greysShown(const Effect& effect, const std::stop_token& stop = {});

} // namespace fumage
