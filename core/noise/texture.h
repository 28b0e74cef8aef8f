#pragma once

#include "core/base/aligned_array.h"
#include "core/base/result.h"
#include "core/effect/effect.h"

#include <stop_token>

namespace fumage {

inline constexpr int kMaxTextureSize = 4096;
static_assert(kMaxNoiseResolution <= kMaxTextureSize);

/// One baked slice of noise.
struct NoiseTile {
    int size = 0;
    AlignedArray<float> values; ///< size * size, row-major, origin bottom-left, in [0, 1]

    /// One texel; x and y in [0, size).
    [[nodiscard]] float at(int x, int y) const
    {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x)];
    }
};

/// Bakes one seamless tile of fractal noise.
/// @param size  tile edge in pixels, 1..kMaxTextureSize; power of two not required
/// @param depth where to cut the third axis, in [0, 1): 0 and 1 are the same slice
/// @return      values after warp, sharpness and coverage
/// @error       TooLarge before allocating; Cancelled if stop was requested
/// Thread-safe. O(size^2 * octaves). Same result for any thread count.
/// Source: the 2012 model (lattice values); Perlin, "Improving Noise", SIGGRAPH 2002 (gradients); seamless because
/// lattices repeat.
[[nodiscard]] Result<NoiseTile> bakeNoise(const Noise& noise, int size, float depth, const std::stop_token& stop = {});

/// The sum of octaves without warp, sharpness and coverage, about 0: what bakeNoise() starts from.
/// @return size * size floats, in [-1, 1] for lattice values, with a standard deviation of about 1/3 for gradients
[[nodiscard]] Result<NoiseTile> bakeFractal(
    const Noise& noise, int size, float depth, const std::stop_token& stop = {});

} // namespace fumage
