#pragma once

#include "core/base/aligned_array.h"

#include <cstdint>
#include <limits>

namespace fumage {

/// The state of every particle at one step: a structure of arrays, one slot a particle, slot = birth index modulo capacity.
/// Arrays are padded to whole chunks; slots that are not alive hold zeros and kUnborn.
struct Particles {
    static constexpr std::int32_t kUnborn = std::numeric_limits<std::int32_t>::max();

    /// Slots that are stepped together: their arrays stay in the first-level cache.
    static constexpr std::size_t kChunk = 1024;

    AlignedArray<float> x, y, z; ///< position, m
    AlignedArray<float> vx, vy, vz; ///< velocity without the turbulence that carries the particle, m/s
    AlignedArray<float> rollX, rollY, rollZ; ///< how far the swirls have turned the particle, a rotation vector in radians; empty where nobody asks
    AlignedArray<std::uint32_t> key; ///< random bits of the particle, see birthKey()
    AlignedArray<std::int32_t> birthStep; ///< kUnborn where the slot is empty
    std::size_t capacity = 0; ///< slots in use at most

    /// Makes room and empties every slot.
    /// @param rolls with room for rollX to rollZ
    void reset(std::size_t slotCount, bool rolls = false)
    {
        capacity = slotCount;
        const std::size_t padded = roundUp(slotCount, kChunk);
        for (AlignedArray<float>* column : {&x, &y, &z, &vx, &vy, &vz}) {
            column->assign(padded, 0.0F);
        }
        for (AlignedArray<float>* column : {&rollX, &rollY, &rollZ}) {
            column->assign(rolls ? padded : 0, 0.0F);
        }
        key.assign(padded, 0U);
        birthStep.assign(padded, kUnborn);
    }

    [[nodiscard]] std::size_t chunks() const { return x.size() / kChunk; }
    [[nodiscard]] bool rolls() const { return !rollX.empty(); }
    [[nodiscard]] std::size_t bytes() const { return x.size() * (rolls() ? 11 : 8) * sizeof(float); }
};

} // namespace fumage
