#pragma once

#include <cstdint>

namespace fumage {

/// Mixes 32 bits so that every output bit depends on every input bit.
/// Source: Wellons, "Prospecting for Hash Functions", 2018 (the constants of "lowbias32", bias 0.17).
[[nodiscard]] constexpr std::uint32_t mixBits(std::uint32_t x)
{
    x ^= x >> 16U;
    x *= 0x7feb352dU;
    x ^= x >> 15U;
    x *= 0x846ca68bU;
    x ^= x >> 16U;
    return x;
}

/// 2^32 divided by the golden ratio, odd: consecutive multiples are spread evenly over 32 bits.
inline constexpr std::uint32_t kGoldenStep = 0x9e3779b9U;

/// Counter-based random bits of a particle: no state, no order.
[[nodiscard]] constexpr std::uint32_t birthKey(std::uint32_t seed, std::uint64_t birthIndex)
{
    const auto low = static_cast<std::uint32_t>(birthIndex);
    const auto high = static_cast<std::uint32_t>(birthIndex >> 32U);
    return mixBits(mixBits(low + seed * kGoldenStep) ^ (high * 0x85ebca6bU + seed));
}

/// Random bits that all particles of a step share; combined with birthKey() they make the draws of that step.
[[nodiscard]] constexpr std::uint32_t stepKey(std::uint32_t seed, std::uint64_t step)
{
    return birthKey(seed ^ 0xa511e9b3U, step);
}

/// One independent stream of random bits per particle and purpose.
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
