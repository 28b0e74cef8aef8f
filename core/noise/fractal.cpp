#include "core/noise/fractal.h"

#include "core/base/hash.h"
#include "core/base/math.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fumage {

namespace {

/// Cells along z are bounded so that their numbers stay far from the limits of int and float.
constexpr float kMaxCells = 65536.0F;

/// A lattice with whole cells, and its part in the blend of two that stands for a frequency between.
struct WholeCells {
    int cells = 1;
    float weight = 0.0F;
};

/// The two whole frequencies around another. They are noises of their own, so that squares of weights sum to 1 for the
/// variance to stay.
std::array<WholeCells, 2> wholeCellsAround(float cells, float most)
{
    /// So near to a whole number the other lattice is not worth its time.
    constexpr float kWhole = 1.0F / 1024.0F;
    const float within = std::clamp(cells, 1.0F, most);
    const float below = std::floor(within);
    const float part = std::clamp((within - below - kWhole) / (1.0F - 2.0F * kWhole), 0.0F, 1.0F);
    const auto whole = static_cast<int>(below);
    if (part == 1.0F) {
        return {WholeCells{whole + 1, 1.0F}, {}};
    }
    return {WholeCells{whole, portableCos(0.5F * kPi * part)},
        {whole + 1, part == 0.0F ? 0.0F : portableSin(0.5F * kPi * part)}};
}

/// How much of an octave is left: all of it up to a cell a pixel; finer ones would only alias, and fade out on the way.
float resolvedShare(float cells, int size)
{
    constexpr float kFade = 0.25F;
    return std::clamp(1.0F - (cells / static_cast<float>(size) - 1.0F) / kFade, 0.0F, 1.0F);
}

/// Lattices that differ by one cell would have the same values near the origin, so every other one has a seed of its
/// own.
std::uint32_t latticeSeed(std::uint32_t octaveSeed, int cells, int planes)
{
    const auto parity = static_cast<std::uint32_t>(cells % 2 + 2 * (planes % 2));
    return parity == 0 ? octaveSeed : streamBits(octaveSeed, parity);
}

} // namespace

std::vector<Octave> fractalOctaves(const Noise& noise, int size)
{
    std::vector<Octave> lattices;
    float sum = 0.0F;
    float variance = 0.0F;
    float resolvedVariance = 0.0F;
    float growth = 1.0F;
    for (int n = 0; n < noise.octaves; ++n, growth *= noise.lacunarity) {
        const float amplitude = portablePow(noise.persistence, static_cast<float>(n));
        const float cells = growth / noise.wavelength;
        const float resolved = amplitude * (n == 0 ? 1.0F : resolvedShare(cells, size));
        sum += amplitude;
        variance += amplitude * amplitude;
        resolvedVariance += resolved * resolved;
        const std::uint32_t seed = streamBits(noise.seed, static_cast<std::uint32_t>(n));
        for (const WholeCells& across : wholeCellsAround(cells, static_cast<float>(size))) {
            for (const WholeCells& deep : wholeCellsAround(noise.depth * growth, kMaxCells)) {
                const float weighted = resolved * across.weight * deep.weight;
                if (weighted > 0.0F) {
                    lattices.push_back({{across.cells, across.cells, deep.cells}, weighted,
                        latticeSeed(seed, across.cells, deep.cells)});
                }
            }
        }
    }
    // The same contrast at every size: octaves that a small tile cannot show leave their part of the variance to the
    // others.
    const float rest = std::sqrt(variance / resolvedVariance);
    for (Octave& lattice : lattices) {
        lattice.amplitude = lattice.amplitude / sum * rest;
    }
    return lattices;
}

} // namespace fumage
