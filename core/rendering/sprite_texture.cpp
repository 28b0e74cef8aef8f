#include "core/rendering/sprite_texture.h"

#include "core/base/parallel.h"
#include "core/noise/texture.h"

#include <algorithm>
#include <atomic>
#include <bit>

namespace fumage {

namespace {

std::uint32_t quantise(float value)
{
    return static_cast<std::uint32_t>(value * 255.0F + 0.5F);
}

/// Halves a tile by averaging blocks of 2 x 2.
AlignedArray<float> halved(const AlignedArray<float>& values, std::size_t edge)
{
    AlignedArray<float> out(edge * edge / 4);
    for (std::size_t y = 0; y < edge / 2; ++y) {
        for (std::size_t x = 0; x < edge / 2; ++x) {
            const float* at = values.data() + 2 * y * edge + 2 * x;
            out[y * (edge / 2) + x] = 0.25F * ((at[0] + at[1]) + (at[edge] + at[edge + 1]));
        }
    }
    return out;
}

/// Counts the greys between texels, bilinearly in the middle of each quarter; where there are very many texels, of one
/// in so many.
void countBetween(const AlignedArray<std::uint32_t>& texels, GreyCounts& greys)
{
    constexpr std::size_t kMax = std::size_t{1} << 18U;
    const std::size_t stride = (texels.size() / kMax) | 1U; // odd: all columns are met
    for (std::size_t i = 0; i < texels.size(); i += stride) {
        const std::uint32_t g00 = texels[i] & 255U;
        const std::uint32_t g10 = texels[i] >> 8U & 255U;
        const std::uint32_t g01 = texels[i] >> 16U & 255U;
        const std::uint32_t g11 = texels[i] >> 24U;
        const auto count = [&](std::uint32_t nearest, std::uint32_t beside, std::uint32_t above,
                               std::uint32_t farthest) {
            ++greys.counts[(9U * nearest + 3U * (beside + above) + farthest + 8U) / 16U];
        };
        count(g00, g10, g01, g11);
        count(g10, g00, g11, g01);
        count(g01, g11, g00, g10);
        count(g11, g01, g10, g00);
    }
}

} // namespace

SpriteTexture::SpriteTexture(int size, int slices)
    : m_size(size)
    , m_slices(slices)
{
    for (int edge = size; edge >= kSmallest; edge /= 2) {
        m_levels.emplace_back(
            static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge) * static_cast<std::size_t>(slices));
    }
}

void SpriteTexture::packSlice(int slice, AlignedArray<float> values)
{
    for (int level = 0; level < levels(); ++level) {
        const auto edge = static_cast<std::size_t>(levelSize(level));
        if (level > 0) {
            values = halved(values, edge * 2);
        }
        std::uint32_t* out =
            m_levels[static_cast<std::size_t>(level)].data() + static_cast<std::size_t>(slice) * edge * edge;
        for (std::size_t y = 0; y < edge; ++y) {
            const float* here = values.data() + y * edge;
            const float* above = values.data() + (y + 1) % edge * edge;
            for (std::size_t x = 0; x < edge; ++x) {
                const std::size_t right = (x + 1) % edge;
                out[y * edge + x] = quantise(here[x]) | quantise(here[right]) << 8U | quantise(above[x]) << 16U
                    | quantise(above[right]) << 24U;
            }
        }
    }
}

void SpriteTexture::countGreys()
{
    m_greys.assign(m_levels.size() + 1, {});
    parallelFor(m_levels.size(), [&](std::size_t level) { countBetween(m_levels[level], m_greys[level]); });
    for (const std::uint32_t texel : m_levels.back()) {
        ++m_greys.back().counts[texel & 255U];
    }
}

SpriteTexture SpriteTexture::pack(int size, const std::vector<AlignedArray<float>>& slices)
{
    SpriteTexture texture(size, static_cast<int>(slices.size()));
    for (std::size_t i = 0; i < slices.size(); ++i) {
        texture.packSlice(static_cast<int>(i), slices[i]);
    }
    texture.countGreys();
    return texture;
}

Result<SpriteTexture> SpriteTexture::bake(const Noise& noise, const std::stop_token& stop)
{
    const int size = std::max(kSmallest, static_cast<int>(std::bit_ceil(static_cast<unsigned>(noise.resolution))));
    SpriteTexture texture(size, noise.slices);
    std::atomic<bool> failed{false};
    parallelFor(static_cast<std::size_t>(noise.slices), [&](std::size_t slice) {
        Result<NoiseTile> tile =
            bakeNoise(noise, size, static_cast<float>(slice) / static_cast<float>(noise.slices), stop);
        if (tile) {
            texture.packSlice(static_cast<int>(slice), std::move(tile).value().values);
        } else {
            failed = true;
        }
    });
    if (failed) {
        return Error{ErrorCode::Cancelled, makeMessage("baking the noise texture was cancelled"), {}, {}};
    }
    texture.countGreys();
    return texture;
}

Result<GreyCounts> greysShown(const Effect& effect, const std::stop_token& stop)
{
    if (effect.look.texture == 0.0F || showsPicture(effect.look)) {
        return GreyCounts{};
    }
    const Result<SpriteTexture> texture = SpriteTexture::bake(effect.noise, stop);
    return texture ? Result<GreyCounts>(texture.value().greys(0)) : texture.error();
}

} // namespace fumage
