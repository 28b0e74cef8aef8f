#pragma once

#include "core/base/aligned_array.h"

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

namespace fumage {

/// Billowed noise in three dimensions for detail that the air carries: the sum of |gradient noise| over octaves, made
/// even, so that all values from -1 to 1 are as frequent. A tile repeats along all axes.
///
/// Levels differ in how many octaves they have, which is also what smaller and smaller pictures can show: level 0 has
/// one octave. Each has as many texels as its finest wave needs.
class DetailTexture {
public:
    static constexpr int kLevels = 4;
    static constexpr int kWaves = 4; ///< of the first octave across a tile
    static constexpr int kTexelsAWave = 4; ///< of the finest octave of a level
    /// Texels along an edge of a level.
    [[nodiscard]] static constexpr int size(int level) { return kWaves * kTexelsAWave << level; }

    /// A value and its slope as numbers from -kFull to kFull, in bytes from the lowest: the value at the texel's
    /// corner, and what it grows by along x, y and z over the texel.
    static constexpr int kFull = 127;

    /// The one that there is, made when it is first asked for. Thread-safe.
    [[nodiscard]] static const DetailTexture& instance();

    /// Bits of x, y and z in the place of a texel: 4 x 2 x 2 of them lie side by side, a cache line, so that a plane
    /// through the tile reads few lines however it is turned.
    static constexpr int kBrickX = 2;
    static constexpr int kBrickY = 1;
    static constexpr int kBrickZ = 1;

    /// Where a texel lies in a level.
    /// @param x,y,z below the size
    [[nodiscard]] static constexpr std::size_t indexOf(int level, std::size_t x, std::size_t y, std::size_t z)
    {
        const auto edge = static_cast<std::size_t>(size(level));
        const std::size_t brick =
            ((z >> kBrickZ) * (edge >> kBrickY) + (y >> kBrickY)) * (edge >> kBrickX) + (x >> kBrickX);
        const auto low = [](std::size_t i, int bits) { return i & ((std::size_t{1} << bits) - 1); };
        const std::size_t inside = (low(z, kBrickZ) << kBrickY | low(y, kBrickY)) << kBrickX | low(x, kBrickX);
        return brick << (kBrickX + kBrickY + kBrickZ) | inside;
    }

    /// @return size^3 texels, each at its indexOf()
    [[nodiscard]] const std::uint32_t* texels(int level) const
    {
        return m_texels[static_cast<std::size_t>(level)].data();
    }
    [[nodiscard]] std::uint32_t texel(int level, std::size_t x, std::size_t y, std::size_t z) const
    {
        return texels(level)[indexOf(level, x, y, z)];
    }

    /// The texels of a level without bricks, x fastest, as graphics libraries take them. O(texels).
    [[nodiscard]] AlignedArray<std::uint32_t> texelsInRows(int level) const;

    /// The value at a place, -1 to 1, and what it grows by over a texel along each axis.
    struct Sample {
        float value;
        glm::vec3 slope;
    };
    /// Linear over a texel as the texels tell it.
    /// @param x,y,z in texels of the level, below 2^20 in magnitude
    [[nodiscard]] Sample sampleAt(int level, float x, float y, float z) const;

    /// The value alone.
    /// @param x,y,z in tiles
    [[nodiscard]] float at(int level, float x, float y, float z) const
    {
        const auto edge = static_cast<float>(size(level));
        return sampleAt(level, x * edge, y * edge, z * edge).value;
    }

private:
    DetailTexture();

    std::array<AlignedArray<std::uint32_t>, kLevels> m_texels;
};

} // namespace fumage
