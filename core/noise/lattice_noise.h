#pragma once

#include "core/effect/effect.h"

#include <array>
#include <cstdint>

namespace fumage {

/// A lattice that repeats: coordinates are taken modulo the period, so that noise on it has no seam.
struct LatticePeriod {
    int x = 1; ///< cells, 1 or more
    int y = 1;
    int z = 1;
};

/// @return i modulo the period, in [0, period), also for negative i
[[nodiscard]] constexpr int wrapped(int i, int period)
{
    const int rest = i % period;
    return rest < 0 ? rest + period : rest;
}

/// The weights of smoothedLatticeValue() along x and along y; their products are 1/4, 1/8 and 1/16.
inline constexpr std::array<float, 3> kSmoothKernel{0.25F, 0.5F, 0.25F};

/// Random bits of a lattice point; one seed, one fixed value a point.
[[nodiscard]] std::uint32_t latticeHash(std::uint32_t seed, const LatticePeriod& period, int x, int y, int z);

/// The lattice noise of the 2012 model: a random value in [0, 1] at each lattice point.
[[nodiscard]] float latticeValue(std::uint32_t seed, const LatticePeriod& period, int x, int y, int z);

/// The smooth function of the 2012 model: the mean of a lattice value and its eight neighbours in the x-y plane,
/// weighted 1/4 for the centre, 1/8 for edges and 1/16 for corners, mixed with the plain value by an amount in [0, 1].
[[nodiscard]] float smoothedLatticeValue(
    std::uint32_t seed, const LatticePeriod& period, int x, int y, int z, float amount);

/// The weight of the upper value between two lattice points: `bottom + weight * (top - bottom)`.
/// Linear: t. Cosine: (1 - cos(pi t)) / 2. Cubic: 3 t^2 - 2 t^3. Quintic: 6 t^5 - 15 t^4 + 10 t^3 (Perlin 2002).
/// @param t in [0, 1]
[[nodiscard]] float interpolationWeight(Interpolation kind, float t);

/// Cubic interpolation between b and c with their outer neighbours, as in the 2012 model:
/// P t^3 + Q t^2 + R t + b, with P = (d - c) - (a - b), Q = (a - b) - P, R = c - a. May leave the range of the values.
[[nodiscard]] float interpolateCubic(float a, float b, float c, float d, float t);

/// The sharpness function of the 2012 model, with coverage: raises the contrast of a grey value about the middle.
/// @return clamp(1/2 + (grey - 1/2) * sharpness + coverage - 1/2) in [0, 1]
[[nodiscard]] float sharpen(float grey, float sharpness, float coverage);

/// Value noise at a point of a repeating lattice: the 2012 model's noise, one octave, before sharpness. One point at a
/// time, to hold bakeFractal() against, which goes row by row.
/// @param x,y,z lattice units, 0 or more
[[nodiscard]] float valueNoise(
    const Noise& noise, std::uint32_t seed, const LatticePeriod& period, float x, float y, float z);

} // namespace fumage
