#pragma once

#include "core/base/aligned_array.h"

#include <array>
#include <cstdint>

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

    /// @return size^3 texels, x fastest
    [[nodiscard]] const std::uint32_t* texels(int level) const
    {
        return m_texels[static_cast<std::size_t>(level)].data();
    }

    /// The value at a place, linear over a texel as the texels tell it.
    /// @param x,y,z in tiles, below 2^20 in magnitude
    [[nodiscard]] float at(int level, float x, float y, float z) const;

private:
    DetailTexture();

    std::array<AlignedArray<std::uint32_t>, kLevels> m_texels;
};

} // namespace fumage
