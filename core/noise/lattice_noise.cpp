#include "core/noise/lattice_noise.h"

#include "core/base/hash.h"
#include "core/base/math.h"
#include "core/noise/lattice_hash.h"

#include <algorithm>
#include <cmath>

namespace fumage {

namespace {

/// Interpolates along one axis; value(i) gives the neighbour i cells on, and only cubic asks for those at -1 and 2.
template <class ValueAt>
float interpolateAxis(Interpolation kind, float t, const ValueAt& value)
{
    if (kind == Interpolation::Cubic) {
        return interpolateCubic(value(-1), value(0), value(1), value(2), t);
    }
    const float bottom = value(0);
    return bottom + interpolationWeight(kind, t) * (value(1) - bottom);
}

/// Value noise at a lattice column, where only y and z need interpolation.
float valueColumn(const Noise& noise, std::uint32_t seed, const LatticePeriod& period, int x, float y, float z)
{
    const float row = std::floor(y);
    const float plane = std::floor(z);
    return interpolateAxis(noise.interpolation, z - plane, [&](int k) {
        return interpolateAxis(noise.interpolation, y - row, [&](int j) {
            return smoothedLatticeValue(
                seed, period, x, static_cast<int>(row) + j, static_cast<int>(plane) + k, noise.smooth);
        });
    });
}

} // namespace

std::uint32_t latticeHash(std::uint32_t seed, const LatticePeriod& period, int x, int y, int z)
{
    return mixLattice(
        latticeColumn(wrapped(x, period.x)) + latticeRow(wrapped(y, period.y), wrapped(z, period.z)), seed);
}

float latticeValue(std::uint32_t seed, const LatticePeriod& period, int x, int y, int z)
{
    return unitFloat(latticeHash(seed, period, x, y, z));
}

float smoothedLatticeValue(std::uint32_t seed, const LatticePeriod& period, int x, int y, int z, float amount)
{
    const float plain = latticeValue(seed, period, x, y, z);
    if (amount == 0.0F) {
        return plain;
    }
    float mean = 0.0F;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            const float weight =
                kSmoothKernel[static_cast<std::size_t>(row)] * kSmoothKernel[static_cast<std::size_t>(column)];
            mean += weight * latticeValue(seed, period, x + column - 1, y + row - 1, z);
        }
    }
    return plain + amount * (mean - plain);
}

float interpolationWeight(Interpolation kind, float t)
{
    switch (kind) {
    case Interpolation::Linear: return t;
    case Interpolation::Cosine: return 0.5F * (1.0F - portableCos(kPi * t));
    case Interpolation::Cubic: return smoothStep(t);
    case Interpolation::Quintic: return t * t * t * (t * (t * 6.0F - 15.0F) + 10.0F);
    }
    return t;
}

float interpolateCubic(float a, float b, float c, float d, float t)
{
    const float p = (d - c) - (a - b);
    const float q = (a - b) - p;
    const float r = c - a;
    return ((p * t + q) * t + r) * t + b;
}

float sharpen(float grey, float sharpness, float coverage)
{
    return std::clamp(0.5F + (grey - 0.5F) * sharpness + (coverage - 0.5F), 0.0F, 1.0F);
}

float valueNoise(const Noise& noise, std::uint32_t seed, const LatticePeriod& period, float x, float y, float z)
{
    const float column = std::floor(x);
    return interpolateAxis(noise.interpolation, x - column,
        [&](int i) { return valueColumn(noise, seed, period, static_cast<int>(column) + i, y, z); });
}

} // namespace fumage
