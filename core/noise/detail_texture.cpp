#include "core/noise/detail_texture.h"

#include "core/base/parallel.h"
#include "core/noise/detail_texture-inl.h"
#include "core/noise/texture.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fumage {

namespace {

constexpr float kGain = 0.5F; ///< amplitude of an octave over that of the one before
constexpr float kRoundCrease = 0.05F; ///< over the noise: |g| as sqrt(g^2 + this^2), whose creases are no cuts

/// A cube of numbers that repeats, x fastest.
struct Cube {
    explicit Cube(int edge)
        : size(edge)
        , values(static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge))
    {
    }

    [[nodiscard]] float at(int x, int y, int z) const
    {
        const auto wrap = [&](int i) { return static_cast<std::size_t>(i & (size - 1)); };
        const auto edge = static_cast<std::size_t>(size);
        return values[(wrap(z) * edge + wrap(y)) * edge + wrap(x)];
    }

    int size;
    AlignedArray<float> values;
};

/// |gradient noise| with the waves of an octave across the tile.
Cube billow(int octave, int size)
{
    constexpr std::uint32_t kSeed = 0x5eed0b11U;
    const int waves = DetailTexture::kWaves << octave;
    Noise noise;
    noise.basis = NoiseBasis::Gradient;
    noise.interpolation = Interpolation::Quintic;
    noise.octaves = 1;
    noise.wavelength = 1.0F / static_cast<float>(waves);
    noise.depth = static_cast<float>(waves);
    noise.seed = kSeed + static_cast<std::uint32_t>(octave);
    Cube out(size);
    const auto edge = static_cast<std::size_t>(size);
    parallelFor(edge, [&](std::size_t z) {
        const float depth = (static_cast<float>(z) + 0.5F) / static_cast<float>(size);
        const NoiseTile slice = bakeFractal(noise, size, depth).value(); // no size is too large, and nobody stops it
        float* to = out.values.data() + z * edge * edge;
        for (std::size_t i = 0; i < edge * edge; ++i) {
            const float g = slice.values[i];
            to[i] = std::sqrt(g * g + kRoundCrease * kRoundCrease);
        }
    });
    return out;
}

/// The share of values below each of many, as a table over their range: what makes them even.
class Equaliser {
public:
    explicit Equaliser(const AlignedArray<float>& values)
    {
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        m_low = *least;
        m_perStep = static_cast<float>(kSteps) / (*most - *least);
        std::vector<std::uint32_t> counts(kSteps + 1, 0U);
        for (const float value : values) {
            ++counts[static_cast<std::size_t>((value - m_low) * m_perStep)];
        }
        std::uint32_t below = 0;
        for (std::size_t i = 0; i < kSteps; ++i) {
            m_shares[i] = static_cast<float>(below) / static_cast<float>(values.size());
            below += counts[i];
        }
        m_shares[kSteps] = 1.0F;
    }

    /// @return in [-1, 1]
    [[nodiscard]] float operator()(float value) const
    {
        const float at = std::clamp((value - m_low) * m_perStep, 0.0F, static_cast<float>(kSteps));
        const auto step = std::min(static_cast<std::size_t>(at), kSteps - 1);
        const float share = m_shares[step] + (m_shares[step + 1] - m_shares[step]) * (at - static_cast<float>(step));
        return 2.0F * share - 1.0F;
    }

private:
    static constexpr std::size_t kSteps = 1024;
    float m_low = 0.0F;
    float m_perStep = 1.0F;
    std::array<float, kSteps + 1> m_shares{};
};

float meanOf(const AlignedArray<float>& values)
{
    double sum = 0.0;
    for (const float value : values) {
        sum += static_cast<double>(value);
    }
    return static_cast<float>(sum / static_cast<double>(values.size()));
}

std::uint32_t packed(const Cube& cube, int x, int y, int z)
{
    constexpr auto kFull = static_cast<float>(DetailTexture::kFull);
    const auto byte = [](float value) {
        const auto number = static_cast<std::int32_t>(std::lround(std::clamp(value, -1.0F, 1.0F) * kFull));
        return static_cast<std::uint32_t>(number) & 255U;
    };
    const auto slope = [](float before, float after) { return 0.5F * (after - before); };
    const float alongX = slope(cube.at(x - 1, y, z), cube.at(x + 1, y, z));
    const float alongY = slope(cube.at(x, y - 1, z), cube.at(x, y + 1, z));
    const float alongZ = slope(cube.at(x, y, z - 1), cube.at(x, y, z + 1));
    const float corner = cube.at(x, y, z) - 0.5F * (alongX + alongY + alongZ);
    return byte(corner) | byte(alongX) << 8U | byte(alongY) << 16U | byte(alongZ) << 24U;
}

} // namespace

DetailTexture::DetailTexture()
{
    std::array<float, kLevels> amplitudes{};
    float amplitude = 1.0F;
    for (float& each : amplitudes) {
        each = amplitude;
        amplitude *= kGain;
    }
    std::vector<Cube> cubes;
    std::array<float, kLevels> means{}; // of the finest octave of each level
    for (int level = 0; level < kLevels; ++level) {
        Cube& cube = cubes.emplace_back(size(level));
        for (int octave = 0; octave <= level; ++octave) {
            const Cube alone = billow(octave, cube.size);
            const auto at = static_cast<std::size_t>(octave);
            for (std::size_t i = 0; i < cube.values.size(); ++i) {
                cube.values[i] += amplitudes[at] * alone.values[i];
            }
            if (octave == level) {
                means[at] = meanOf(alone.values);
            }
        }
    }
    const Equaliser even(cubes.back().values);
    float lacking = 0.0F;
    for (int level = kLevels - 1; level >= 0; --level) {
        Cube& cube = cubes[static_cast<std::size_t>(level)];
        for (float& value : cube.values) {
            value = even(value + lacking);
        }
        // What octaves that a level lacks have on average: without it, coarser levels would be lower.
        lacking += amplitudes[static_cast<std::size_t>(level)] * means[static_cast<std::size_t>(level)];
        AlignedArray<std::uint32_t>& to = m_texels[static_cast<std::size_t>(level)];
        to.resize(cube.values.size());
        const auto edge = static_cast<std::size_t>(cube.size);
        parallelFor(edge, [&](std::size_t z) {
            for (std::size_t y = 0; y < edge; ++y) {
                for (std::size_t x = 0; x < edge; ++x) {
                    to[indexOf(level, x, y, z)] =
                        packed(cube, static_cast<int>(x), static_cast<int>(y), static_cast<int>(z));
                }
            }
        });
    }
}

const DetailTexture& DetailTexture::instance()
{
    static const DetailTexture texture;
    return texture;
}

AlignedArray<std::uint32_t> DetailTexture::texelsInRows(int level) const
{
    const auto edge = static_cast<std::size_t>(size(level));
    AlignedArray<std::uint32_t> out;
    out.reserve(edge * edge * edge);
    for (std::size_t z = 0; z < edge; ++z) {
        for (std::size_t y = 0; y < edge; ++y) {
            for (std::size_t x = 0; x < edge; ++x) {
                out.push_back(texel(level, x, y, z));
            }
        }
    }
    return out;
}

} // namespace fumage

// What the instruction set of the kernels needs, NEON's for instance, is asked for here too.
HWY_BEFORE_NAMESPACE();
namespace fumage {

DetailTexture::Sample DetailTexture::sampleAt(int level, float x, float y, float z) const
{
    namespace hn = hwy::HWY_NAMESPACE;
    const hn::CappedTag<float, 1> d;
    const auto [value, slope] = HWY_NAMESPACE::samplesAt(d, *this, level, HWY_NAMESPACE::broadcast(d, {x, y, z}));
    return {hn::GetLane(value), {hn::GetLane(slope.x), hn::GetLane(slope.y), hn::GetLane(slope.z)}};
}

} // namespace fumage
HWY_AFTER_NAMESPACE();
