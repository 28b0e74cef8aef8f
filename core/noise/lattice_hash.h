#pragma once

#include <cstdint>

namespace fumage {

// The hash of lattice points in two parts, so that a row of points shares one of them. The same constants as simplex-inl.h.

inline constexpr std::uint32_t kColumnPrime = 0x9e3779b1U;
inline constexpr std::uint32_t kRowPrime = 0x85ebca77U;
inline constexpr std::uint32_t kLayerPrime = 0xc2b2ae3dU;

[[nodiscard]] constexpr std::uint32_t latticeColumn(int x)
{
    return static_cast<std::uint32_t>(x) * kColumnPrime;
}

[[nodiscard]] constexpr std::uint32_t latticeRow(int y, int z)
{
    return static_cast<std::uint32_t>(y) * kRowPrime + static_cast<std::uint32_t>(z) * kLayerPrime;
}

/// @param linear latticeColumn() + latticeRow()
[[nodiscard]] constexpr std::uint32_t mixLattice(std::uint32_t linear, std::uint32_t seed)
{
    std::uint32_t bits = linear ^ seed;
    bits = (bits ^ (bits >> 15U)) * 0x2c1b3c6dU;
    bits = (bits ^ (bits >> 12U)) * 0x297a2d39U;
    return bits ^ (bits >> 15U);
}

} // namespace fumage
