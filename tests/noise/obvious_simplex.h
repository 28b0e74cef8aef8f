#pragma once

#include "core/base/hash.h"
#include "core/noise/fractal.h"
#include "core/noise/lattice_hash.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fumage::tests {

/// Simplex noise at one point, as textbooks have it: skew, sort the fractions, sum over the four corners. Before the
/// scale of the octave.
/// @param x,y,z lattice units
template <class Real>
Real obviousSimplex(const Octave& octave, Real x, Real y, Real z)
{
    // The cube that the simplex lies in, and the fractions within; the way to the opposite corner takes the axis of the
    // largest first.
    const std::array<Real, 3> skewed{y + z, x + z, x + y};
    std::array<int, 3> corner{};
    std::array<Real, 3> fraction{};
    for (std::size_t i = 0; i < 3; ++i) {
        corner[i] = static_cast<int>(std::floor(skewed[i]));
        fraction[i] = skewed[i] - static_cast<Real>(corner[i]);
    }
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return fraction[a] > fraction[b]; });
    Real sum = 0;
    for (std::size_t step = 0;; ++step) {
        // Doubled coordinates are whole.
        const int px = corner[1] + corner[2] - corner[0];
        const int py = corner[0] + corner[2] - corner[1];
        const int pz = corner[0] + corner[1] - corner[2];
        const Real dx = x - static_cast<Real>(px) / 2;
        const Real dy = y - static_cast<Real>(py) / 2;
        const Real dz = z - static_cast<Real>(pz) / 2;
        const Real t = static_cast<Real>(0.5) - (dx * dx + dy * dy + dz * dz);
        if (t > 0) {
            const LatticePeriod& period = octave.period;
            const std::uint32_t bits = mixLattice(latticeColumn(wrapped(px, 2 * period.x))
                    + latticeRow(wrapped(py, 2 * period.y), wrapped(pz, 2 * period.z)),
                octave.seed);
            const auto component = [&](std::uint32_t shift) {
                return static_cast<Real>(static_cast<std::int32_t>(bits << shift)) * static_cast<Real>(0x1p-31);
            };
            sum += t * t * t * t * (dx * component(0) + dy * component(11) + dz * component(22));
        }
        if (step == 3) {
            return sum;
        }
        ++corner[order[step]];
    }
}

} // namespace fumage::tests
