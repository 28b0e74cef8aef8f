#pragma once

#include "core/noise/lattice_noise.h"

#include <vector>

namespace fumage {

/// One octave of noise on a tile.
struct Octave {
    LatticePeriod period; ///< lattice cells across the tile, and along z
    float amplitude = 1.0F; ///< persistence^n, divided by the sum over all octaves
    std::uint32_t seed = 0;
};

/// The octaves of a noise on a tile of size by size pixels: octave n has frequency lacunarity^n / wavelength, rounded to whole cells
/// a tile so that there is no seam, and amplitude persistence^n. Octaves finer than a pixel are left out: they would only alias.
/// @param size 1 or more
[[nodiscard]] std::vector<Octave> fractalOctaves(const Noise& noise, int size);

} // namespace fumage
