#pragma once

#include <cstdint>

namespace fumage {

/// Odd numbers of well spread bits, to multiply coordinates and counters with. Source: the primes of xxHash32, Collet
/// 2012.
inline constexpr std::uint32_t kPrime1 = 0x9e3779b1U;
inline constexpr std::uint32_t kPrime2 = 0x85ebca77U;
inline constexpr std::uint32_t kPrime3 = 0xc2b2ae3dU;

/// The factors of mixBits(). Source: Wellons, "Prospecting for Hash Functions", 2018 ("lowbias32", bias 0.17).
inline constexpr std::uint32_t kMixFactor1 = 0x7feb352dU;
inline constexpr std::uint32_t kMixFactor2 = 0x846ca68bU;

/// Mixes 32 bits so that every output bit depends on every input bit.
[[nodiscard]] constexpr std::uint32_t mixBits(std::uint32_t x)
{
    x ^= x >> 16U;
    x *= kMixFactor1;
    x ^= x >> 15U;
    x *= kMixFactor2;
    x ^= x >> 16U;
    return x;
}

/// 2^32 divided by the golden ratio, odd: consecutive multiples are spread evenly over 32 bits.
inline constexpr std::uint32_t kGoldenStep = 0x9e3779b9U;

/// Spreads the upper half of a 64-bit index. Source: MurmurHash3, Appleby 2011.
inline constexpr std::uint32_t kUpperHalfFactor = 0x85ebca6bU;

/// Random bits of one among many things that are counted, such as particles, steps or slices of noise: no state, no
/// order.
[[nodiscard]] constexpr std::uint32_t keyOf(std::uint32_t seed, std::uint64_t index)
{
    const auto low = static_cast<std::uint32_t>(index);
    const auto high = static_cast<std::uint32_t>(index >> 32U);
    return mixBits(mixBits(low + seed * kGoldenStep) ^ (high * kUpperHalfFactor + seed));
}

/// Random bits that all particles of a step share; combined with those of a particle they make its draws of that step.
[[nodiscard]] constexpr std::uint32_t stepKey(std::uint32_t seed, std::uint64_t step)
{
    constexpr std::uint32_t kApart = 0xa511e9b3U; // from the keys of particles
    return keyOf(seed ^ kApart, step);
}

/// One independent stream of random bits for each purpose that a key has.
[[nodiscard]] constexpr std::uint32_t streamBits(std::uint32_t key, std::uint32_t stream)
{
    return mixBits(key + (stream + 1U) * kGoldenStep);
}

/// @return uniform in [0, 1), a multiple of 2^-24: exact in float
[[nodiscard]] constexpr float unitFloat(std::uint32_t bits)
{
    return static_cast<float>(bits >> 8U) * 0x1p-24F;
}

/// @return uniform in [-1, 1], the rand() of the 2012 model
[[nodiscard]] constexpr float signedFloat(std::uint32_t bits)
{
    return static_cast<float>(static_cast<std::int32_t>(bits)) * 0x1p-31F;
}

} // namespace fumage
