#pragma once

#include "core/noise/lattice_noise.h"

#include <vector>

namespace fumage {

/// One octave of noise on a tile, or its part on one of the lattices that it is a blend of.
struct Octave {
    LatticePeriod period; ///< lattice cells across the tile, and along z
    float amplitude = 1.0F; ///< of the values in [-1, 1]; the sum over all octaves is 1, where the tile shows them all
    std::uint32_t seed = 0;
};

/// The octaves of a noise on a tile of size by size pixels: octave n has frequency lacunarity^n / wavelength and
/// amplitude persistence^n. A tile without a seam needs whole cells, so that a frequency between two whole ones (and so
/// with depth) is a blend of both lattices, weighted cos(a) and sin(a): parameters act continuously, and contrast
/// stays. Octaves finer than a pixel would only alias; they fade out, and leave their part of the variance to the
/// others: contrast does not depend on the size.
/// @param size 1 or more
[[nodiscard]] std::vector<Octave> fractalOctaves(const Noise& noise, int size);

} // namespace fumage
