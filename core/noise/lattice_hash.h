#pragma once

#include "core/base/hash.h"

namespace fumage {

// The hash of lattice points in two parts, so that a row of points shares one of them.

inline constexpr std::uint32_t kColumnPrime = kPrime1;
inline constexpr std::uint32_t kRowPrime = kPrime2;
inline constexpr std::uint32_t kPlanePrime = kPrime3;

/// The share of x in the hash of a lattice point; mixed with latticeRow() by XOR.
[[nodiscard]] constexpr std::uint32_t latticeColumn(int x)
{
    return static_cast<std::uint32_t>(x) * kColumnPrime;
}

/// The share of y and z in the hash of a lattice point: the same for a whole row.
[[nodiscard]] constexpr std::uint32_t latticeRow(int y, int z)
{
    return static_cast<std::uint32_t>(y) * kRowPrime + static_cast<std::uint32_t>(z) * kPlanePrime;
}

/// The factors of mixLattice().
inline constexpr std::uint32_t kLatticeFactor1 = 0x2c1b3c6dU;
inline constexpr std::uint32_t kLatticeFactor2 = 0x297a2d39U;

/// Mixes the linear hash of a lattice point; all 32 bits are usable.
/// @param linear latticeColumn() + latticeRow(), or what simplexCorners() finds
/// Source: Wellons, "Prospecting for Hash Functions", 2018 (a family of xor, shift and multiply).
[[nodiscard]] constexpr std::uint32_t mixLattice(std::uint32_t linear, std::uint32_t seed)
{
    std::uint32_t bits = linear ^ seed;
    bits = (bits ^ (bits >> 15U)) * kLatticeFactor1;
    bits = (bits ^ (bits >> 12U)) * kLatticeFactor2;
    return bits ^ (bits >> 15U);
}

} // namespace fumage
