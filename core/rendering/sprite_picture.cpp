#include "core/rendering/sprite_picture.h"

#include "core/rendering/view_transform.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fumage {

namespace {

constexpr std::size_t kBytes = 256;

std::array<float, kBytes> linearBytes()
{
    std::array<float, kBytes> linear{};
    for (std::size_t i = 0; i < kBytes; ++i) {
        linear[i] = linearFromSrgb(static_cast<float>(i) / 255.0F);
    }
    return linear;
}

/// Means of blocks of 2 x 2 texels.
AlignedArray<float> halved(const AlignedArray<float>& texels, std::size_t edge)
{
    constexpr std::size_t kChannels = SpritePicture::kChannels;
    AlignedArray<float> out(edge * edge / 4 * kChannels);
    for (std::size_t y = 0; y < edge / 2; ++y) {
        for (std::size_t x = 0; x < edge / 2; ++x) {
            const float* at = texels.data() + (2 * y * edge + 2 * x) * kChannels;
            const float* below = at + edge * kChannels;
            for (std::size_t i = 0; i < kChannels; ++i) {
                out[(y * (edge / 2) + x) * kChannels + i] =
                    0.25F * ((at[i] + at[kChannels + i]) + (below[i] + below[kChannels + i]));
            }
        }
    }
    return out;
}

/// What of two neighbouring pixels lies in a texel, over what there is room for.
struct Overlap {
    int first = 0; ///< the other is the next
    float share = 0.0F;
    float shareOfNext = 0.0F;
};

/// @param edge of the picture that runs this way, in the middle of its longer one
/// @param size texels that the longer one has, at most twice as many
std::vector<Overlap> overlapsOf(int edge, int longer, int size)
{
    const float pixels = static_cast<float>(longer) / static_cast<float>(size); // a texel
    const float before = 0.5F * static_cast<float>(longer - edge);
    std::vector<Overlap> overlaps;
    for (int texel = 0; texel < size; ++texel) {
        const float start = static_cast<float>(texel) * pixels - before;
        const float first = std::floor(start);
        const float inside = std::min(pixels, first + 1.0F - start);
        overlaps.push_back({static_cast<int>(first), inside / pixels, (pixels - inside) / pixels});
    }
    return overlaps;
}

using Texel = std::array<float, SpritePicture::kChannels>;

/// Premultiplied linear light of all pixels, rows from the top.
std::vector<Texel> lightOf(const Bitmap& bitmap)
{
    const std::array<float, kBytes> linear = linearBytes();
    const std::span<const std::uint8_t> pixels = bitmap.pixels();
    std::vector<Texel> light;
    for (std::size_t i = 0; i < pixels.size(); i += SpritePicture::kChannels) {
        const float alpha = static_cast<float>(pixels[i + 3]) / 255.0F;
        light.push_back(
            {linear[pixels[i]] * alpha, linear[pixels[i + 1]] * alpha, linear[pixels[i + 2]] * alpha, alpha});
    }
    return light;
}

} // namespace

int SpritePicture::sizeFor(const Bitmap& bitmap)
{
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(bitmap.width(), bitmap.height()))));
}

SpritePicture::SpritePicture(const Bitmap& bitmap)
    : m_size(sizeFor(bitmap))
{
    const int longer = std::max(bitmap.width(), bitmap.height());
    const std::vector<Overlap> across = overlapsOf(bitmap.width(), longer, m_size);
    const std::vector<Overlap> down = overlapsOf(bitmap.height(), longer, m_size);
    const std::vector<Texel> light = lightOf(bitmap);
    AlignedArray<float> finest;
    const auto add = [&](int x, int y, float share, Texel& to) {
        if (x < 0 || y < 0 || x >= bitmap.width() || y >= bitmap.height()) {
            return; // transparent
        }
        const Texel& from =
            light[static_cast<std::size_t>(y) * static_cast<std::size_t>(bitmap.width()) + static_cast<std::size_t>(x)];
        for (std::size_t i = 0; i < kChannels; ++i) {
            to[i] += share * from[i];
        }
    };
    for (const Overlap& y : down) {
        for (const Overlap& x : across) {
            Texel texel{};
            add(x.first, y.first, x.share * y.share, texel);
            add(x.first + 1, y.first, x.shareOfNext * y.share, texel);
            add(x.first, y.first + 1, x.share * y.shareOfNext, texel);
            add(x.first + 1, y.first + 1, x.shareOfNext * y.shareOfNext, texel);
            finest.insert(finest.end(), texel.begin(), texel.end());
        }
    }
    m_levels.push_back(std::move(finest));
    for (auto size = static_cast<std::size_t>(m_size); size > 1; size /= 2) {
        m_levels.push_back(halved(m_levels.back(), size));
    }
}

} // namespace fumage
