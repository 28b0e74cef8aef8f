#include "core/noise/fractal.h"

#include "core/base/hash.h"
#include "core/base/math.h"

#include <algorithm>
#include <cmath>

namespace fumage {

namespace {

/// Cells along z are bounded so that their numbers stay far from the limits of int and float.
constexpr float kMostCells = 65536.0F;

int wholeCells(float cells, float most)
{
    return static_cast<int>(std::clamp(std::round(cells), 1.0F, most));
}

} // namespace

std::vector<Octave> fractalOctaves(const Noise& noise, int size)
{
    std::vector<Octave> octaves;
    float sum = 0.0F;
    for (int n = 0; n < noise.octaves; ++n) {
        const float order = static_cast<float>(n);
        const float growth = portablePow(noise.lacunarity, order);
        const float cells = growth / noise.wavelength;
        if (n > 0 && cells > static_cast<float>(size)) {
            break;
        }
        Octave octave;
        octave.period.x = wholeCells(cells, static_cast<float>(size));
        octave.period.y = octave.period.x;
        octave.period.z = wholeCells(noise.depth * growth, kMostCells);
        octave.amplitude = portablePow(noise.persistence, order);
        octave.seed = streamBits(noise.seed, static_cast<std::uint32_t>(n));
        sum += octave.amplitude;
        octaves.push_back(octave);
    }
    for (Octave& octave : octaves) {
        octave.amplitude /= sum;
    }
    return octaves;
}

} // namespace fumage
