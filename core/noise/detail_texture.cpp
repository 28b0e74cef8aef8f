#include "core/noise/detail_texture.h"

#include "core/base/parallel.h"
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

/// Adds |gradient noise| of some waves across the tile.
void addBillow(int octave, float amplitude, Cube& to)
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
    const auto edge = static_cast<std::size_t>(to.size);
    parallelFor(edge, [&](std::size_t z) {
        const float depth = (static_cast<float>(z) + 0.5F) / static_cast<float>(to.size);
        const NoiseTile slice = bakeFractal(noise, to.size, depth).value(); // no size is too large, and nobody stops it
        float* out = to.values.data() + z * edge * edge;
        for (std::size_t i = 0; i < edge * edge; ++i) {
            const float g = slice.values[i];
            out[i] += amplitude * std::sqrt(g * g + kRoundCrease * kRoundCrease);
        }
    });
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

/// What octaves that a level lacks have on average: without it, coarser levels would be lower.
float meanOf(int octave)
{
    Cube alone(DetailTexture::size(octave));
    addBillow(octave, 1.0F, alone);
    double sum = 0.0;
    for (const float value : alone.values) {
        sum += static_cast<double>(value);
    }
    return static_cast<float>(sum / static_cast<double>(alone.values.size()));
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

/// A number in the byte of a texel, the lowest being 0.
float numberIn(std::uint32_t texel, unsigned byte)
{
    return static_cast<float>(static_cast<std::int8_t>(texel >> 8U * byte & 255U));
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
    for (int level = 0; level < kLevels; ++level) {
        Cube& cube = cubes.emplace_back(size(level));
        for (int octave = 0; octave <= level; ++octave) {
            addBillow(octave, amplitudes[static_cast<std::size_t>(octave)], cube);
        }
    }
    const Equaliser even(cubes.back().values);
    float lacking = 0.0F;
    for (int level = kLevels - 1; level >= 0; --level) {
        Cube& cube = cubes[static_cast<std::size_t>(level)];
        for (float& value : cube.values) {
            value = even(value + lacking);
        }
        lacking += amplitudes[static_cast<std::size_t>(level)] * meanOf(level);
        AlignedArray<std::uint32_t>& to = m_texels[static_cast<std::size_t>(level)];
        to.resize(cube.values.size());
        const auto edge = static_cast<std::size_t>(cube.size);
        parallelFor(edge, [&](std::size_t z) {
            for (std::size_t y = 0; y < edge; ++y) {
                for (std::size_t x = 0; x < edge; ++x) {
                    to[(z * edge + y) * edge + x] =
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

float DetailTexture::at(int level, float x, float y, float z) const
{
    const auto edge = static_cast<float>(size(level));
    const auto split = [&](float tiles, float& part) {
        const float texels = tiles * edge;
        const float whole = std::floor(texels);
        part = texels - whole;
        return static_cast<std::size_t>(static_cast<std::int64_t>(whole) & (size(level) - 1));
    };
    float partX = 0.0F;
    float partY = 0.0F;
    float partZ = 0.0F;
    const std::size_t atX = split(x, partX);
    const std::size_t atY = split(y, partY);
    const std::size_t atZ = split(z, partZ);
    const auto row = static_cast<std::size_t>(size(level));
    const std::uint32_t texel = texels(level)[(atZ * row + atY) * row + atX];
    const float sum =
        numberIn(texel, 0) + partX * numberIn(texel, 1) + partY * numberIn(texel, 2) + partZ * numberIn(texel, 3);
    return sum * (1.0F / static_cast<float>(kFull));
}

} // namespace fumage
