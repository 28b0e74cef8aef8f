#pragma once

#include "core/base/hash.h"

#include <array>
#include <cstdint>

namespace fumage {

// The linear hash of a lattice point (u, v, w) is the sum of these, each times its coordinate; see simplex-inl.h.
inline constexpr std::uint32_t kLatticeU = kPrime1;
inline constexpr std::uint32_t kLatticeV = kPrime2;
inline constexpr std::uint32_t kLatticeW = kPrime3;

/// 1 / root mean square of a component of the raw curl noise of simplex-inl.h, measured over 10^6 points; includes the
/// 2^-31 of its random components.
inline constexpr float kCurlNormalisation = 87.0F * 0x1p-31F;

/// Random vectors of curl noise's lattice points: one or two sets of them, weighted and summed.
struct CurlSlices {
    std::array<std::uint32_t, 2> key{};
    std::array<float, 2>
        weight{}; ///< of each set, times 2^-31, which its integer components lack; second 0: one set only
    std::array<std::uint32_t, 2> shift{}; ///< see latticeShift()
};

/// What moves a set up by whole units of y: u = y + z and w = x + y of every point fall by as many.
[[nodiscard]] constexpr std::uint32_t latticeShift(std::int64_t units)
{
    return static_cast<std::uint32_t>(-units) * (kLatticeU + kLatticeW);
}

} // namespace fumage
