#include "core/export/sheets/layer_colours.h"

#include "core/base/parallel.h"
#include "core/export/sheets/bleed.h"
#include "core/rendering/view_transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fumage {

namespace {

constexpr std::size_t kAlpha = 3;

/// One pixel of a sheet and of all of its layers: what each is to have, and what it gets.
struct Pixel {
    std::size_t layers = 0;
    std::array<double, 4> whole{}; ///< as it is shown, in the numbers in which layers add up
    std::array<std::array<double, 4>, kMaxLayers> share; ///< NOLINT: as many as there are layers are set
    std::array<std::array<float, 4>, kMaxLayers> out; ///< NOLINT
};

/// How numbers between 0 and 1 are stored, and what they are then.
struct Store {
    double full = 0.0; ///< 0: floats
    bool isLinear = false; ///< colours are sRGB of the numbers that add up
    bool isStraight = false; ///< colours are divided by alpha

    [[nodiscard]] double step(double number) const
    {
        return std::floor(std::clamp(number, 0.0, 1.0) * full + 0.5) / full;
    }
    /// @return what is stored
    [[nodiscard]] double colour(double number) const
    {
        if (full == 0.0) {
            return number;
        }
        return step(isLinear ? static_cast<double>(srgbFromLinear(static_cast<float>(std::max(number, 0.0)))) : number);
    }
    /// What somebody adds who reads it.
    [[nodiscard]] double read(double stored) const
    {
        return isLinear ? static_cast<double>(linearFromSrgb(static_cast<float>(stored))) : stored;
    }
    [[nodiscard]] double alpha(double number) const { return full == 0.0 ? number : step(number); }
};

/// Divides a whole by weights; where none weighs anything there is nothing to divide.
void divide(Pixel& pixel, std::size_t channel, const std::array<double, kMaxLayers>& weights)
{
    double sum = 0.0;
    for (std::size_t k = 0; k < pixel.layers; ++k) {
        sum += weights[k];
    }
    for (std::size_t k = 0; k < pixel.layers; ++k) {
        pixel.share[k][channel] = sum > 0.0 ? pixel.whole[channel] * (weights[k] / sum) : 0.0;
    }
    if (!(sum > 0.0)) {
        pixel.share[0][channel] = pixel.whole[channel];
    }
}

/// @param at where the pixel's channels begin in the contributions
void findShares(std::span<const PassSheet> layers, std::size_t at, Pixel& pixel)
{
    std::array<double, kMaxLayers> weights{};
    std::array<double, kMaxLayers> light{};
    double covered = 0.0;
    double lit = 0.0;
    for (std::size_t channel = 0; channel < kAlpha; ++channel) {
        for (std::size_t k = 0; k < pixel.layers; ++k) {
            weights[k] = static_cast<double>(layers[k].targets.of(PassTarget::Colour).pixels[at + channel]);
            light[k] += weights[k];
            lit += weights[k];
        }
        divide(pixel, channel, weights);
    }
    for (std::size_t k = 0; k < pixel.layers; ++k) {
        weights[k] = static_cast<double>(layers[k].targets.of(PassTarget::Colour).pixels[at + kAlpha]);
        covered += weights[k];
    }
    const double byLight = std::max(0.0, pixel.whole[kAlpha] - covered);
    for (std::size_t k = 0; lit > 0.0 && k < pixel.layers; ++k) {
        weights[k] += byLight * (light[k] / lit);
    }
    divide(pixel, kAlpha, weights);
}

/// Divides the alpha once more, so that each layer has at least as much as light: those that are drawn last first.
void coverLight(Pixel& pixel)
{
    std::array<double, kMaxLayers> beyond{}; // of what a layer covers, more than its light
    double covered = 0.0;
    double left = pixel.whole[kAlpha];
    for (std::size_t k = pixel.layers; k-- > 0;) {
        std::array<double, 4>& share = pixel.share[k];
        const double light = std::max({share[0], share[1], share[2]});
        beyond[k] = std::max(0.0, share[kAlpha] - light);
        covered += beyond[k];
        share[kAlpha] = std::min(light, left);
        left -= share[kAlpha];
    }
    for (std::size_t k = 0; k < pixel.layers; ++k) {
        pixel.share[k][kAlpha] += covered > 0.0 ? left * (beyond[k] / covered) : k == 0 ? left : 0.0;
    }
}

/// Rounds shares of a whole so that their sum is the whole, rounded: down, and those up that lost most.
void roundTogether(Pixel& pixel, std::size_t channel, double full)
{
    std::array<double, kMaxLayers> lost{};
    auto left = static_cast<int>(std::floor(std::clamp(pixel.whole[channel], 0.0, 1.0) * full + 0.5));
    for (std::size_t k = 0; k < pixel.layers; ++k) {
        const double wanted = pixel.share[k][channel] * full;
        const double steps = std::min(std::floor(wanted), static_cast<double>(left));
        lost[k] = wanted - steps;
        left -= static_cast<int>(steps);
        pixel.out[k][channel] = static_cast<float>(steps / full);
    }
    for (; left > 0; --left) {
        const auto end = lost.begin() + static_cast<std::ptrdiff_t>(pixel.layers);
        const auto most = static_cast<std::size_t>(std::max_element(lost.begin(), end) - lost.begin());
        lost[most] -= 1.0;
        pixel.out[most][channel] =
            static_cast<float>((std::round(static_cast<double>(pixel.out[most][channel]) * full) + 1.0) / full);
    }
}

/// What the layers above leave of each layer, and all of them of what is behind.
struct Seen {
    std::array<double, kMaxLayers> layers; ///< NOLINT: as many as there are layers are set
    double behind = 0.0;
};

/// Stores the colours of all layers, each with what those before it could not take.
void storeColours(Pixel& pixel, std::size_t channel, const Store& store, const Seen& seen)
{
    double drawn = 0.0; // of the picture, with this layer and those before
    double carried = 0.0;
    for (std::size_t k = 0; k < pixel.layers; ++k) {
        const double left = seen.layers[k];
        const double wanted = pixel.share[k][channel] + carried;
        const double light = store.isStraight ? left * static_cast<double>(pixel.out[k][kAlpha]) : left; // of a 1
        const bool isSeen = (left >= static_cast<double>(kMinSeen) || k + 1 == pixel.layers) && light > 0.0;
        const double most = store.full == 0.0 ? wanted : std::max(0.0, left - seen.behind - drawn);
        const double stored = isSeen ? store.colour(std::clamp(wanted, 0.0, most) / light) : 0.0;
        pixel.out[k][channel] = static_cast<float>(stored);
        const double given = store.read(static_cast<double>(pixel.out[k][channel])) * light;
        drawn += given;
        carried = wanted - given;
    }
}

void contribute(Pixel& pixel, const Store& store)
{
    Seen seen; // NOLINT: set here
    seen.layers.fill(1.0);
    for (std::size_t channel = 0; channel < 4; ++channel) {
        if (store.isLinear && channel != kAlpha) {
            storeColours(pixel, channel, store, seen);
        } else {
            roundTogether(pixel, channel, store.full);
        }
    }
}

Seen stackAlpha(Pixel& pixel, const Store& store)
{
    Seen seen; // NOLINT: set here
    double above = 0.0;
    double left = 1.0;
    for (std::size_t k = pixel.layers; k-- > 0;) {
        seen.layers[k] = left;
        above += pixel.share[k][kAlpha];
        const double wanted = left > 0.0 ? 1.0 - (1.0 - above) / left : 0.0;
        const double alpha = std::clamp(store.alpha(wanted), 0.0, 1.0);
        pixel.out[k][kAlpha] = static_cast<float>(alpha);
        left *= 1.0 - static_cast<double>(pixel.out[k][kAlpha]);
    }
    seen.behind = left;
    return seen;
}

void stack(Pixel& pixel, const Store& store)
{
    if (store.isStraight) {
        coverLight(pixel);
    }
    const Seen seen = stackAlpha(pixel, store);
    for (std::size_t channel = 0; channel < kAlpha; ++channel) {
        storeColours(pixel, channel, store, seen);
    }
}

/// What a sheet shows over black, of numbers as files have them.
template <class Channel>
std::vector<float> shownOf(const Image& image, const Scene& scene, bool isLinear)
{
    Output output = scene.output;
    output.background = Background::Transparent;
    EncodedImage<Channel> encoded;
    encode(image, output, encoded, coverOf(scene));
    constexpr auto kFull = static_cast<float>(std::numeric_limits<Channel>::max());
    std::vector<float> shown(encoded.pixels.size());
    parallelFor(static_cast<std::size_t>(image.height), [&](std::size_t y) {
        const std::size_t row = static_cast<std::size_t>(image.width) * 4;
        for (std::size_t i = y * row; i < (y + 1) * row; i += 4) {
            const float alpha = static_cast<float>(encoded.pixels[i + kAlpha]) / kFull;
            for (std::size_t channel = 0; channel < kAlpha; ++channel) {
                const float colour = static_cast<float>(encoded.pixels[i + channel]) / kFull;
                shown[i + channel] = (isLinear ? linearFromSrgb(colour) : colour) * alpha;
            }
            shown[i + kAlpha] = alpha;
        }
    });
    return shown;
}

std::vector<float> shownOf(const Image& image, const Scene& scene, ImageFormat format, bool isLinear)
{
    if (holdsFloats(format)) {
        return {image.pixels.begin(), image.pixels.end()};
    }
    return format == ImageFormat::Png16 ? shownOf<std::uint16_t>(image, scene, isLinear)
                                        : shownOf<std::uint8_t>(image, scene, isLinear);
}

/// Lets straight colours go on under transparency.
template <class Channel>
void bleed(const SheetGrid& grid, DataImage& image)
{
    constexpr auto kFull = static_cast<float>(std::numeric_limits<Channel>::max());
    EncodedImage<Channel> encoded{image.width, image.height, {}};
    encoded.pixels.resize(image.values.size());
    std::ranges::transform(image.values, encoded.pixels.begin(),
        [](float value) { return static_cast<Channel>(std::lround(value * kFull)); });
    bleedColours(encoded, grid.cellWidth, grid.cellHeight);
    std::ranges::transform(
        encoded.pixels, image.values.begin(), [](Channel value) { return static_cast<float>(value) / kFull; });
}

} // namespace

std::vector<DataImage> layerColours(const Image& whole, std::span<const PassSheet> layers, const Scene& scene,
    LayerOutput output, const LayerStore& how)
{
    const bool hasFloats = holdsFloats(how.format);
    const Store store{hasFloats ? 0.0 : static_cast<double>(fullOf(how.format)),
        !hasFloats && how.space == BlendSpace::Linear, how.isStraight};
    const std::vector<float> shown = shownOf(whole, scene, how.format, store.isLinear);
    std::vector<DataImage> out;
    for (std::size_t k = 0; k < layers.size(); ++k) {
        out.push_back({whole.width, whole.height, 4, false, {}, !hasFloats});
        out.back().values.assign(shown.size(), 0.0F);
    }
    parallelFor(static_cast<std::size_t>(whole.height), [&](std::size_t y) {
        Pixel pixel; // NOLINT: see its members
        pixel.layers = layers.size();
        const std::size_t row = static_cast<std::size_t>(whole.width) * 4;
        for (std::size_t i = y * row; i < (y + 1) * row; i += 4) {
            std::copy_n(shown.begin() + static_cast<std::ptrdiff_t>(i), 4, pixel.whole.begin());
            if (std::ranges::all_of(pixel.whole, [](double number) { return number == 0.0; })) {
                continue; // as there are many; the numbers are 0 already
            }
            findShares(layers, i, pixel);
            output == LayerOutput::Stacked ? stack(pixel, store) : contribute(pixel, store);
            for (std::size_t k = 0; k < layers.size(); ++k) {
                std::copy_n(pixel.out[k].begin(), 4, out[k].values.begin() + static_cast<std::ptrdiff_t>(i));
            }
        }
    });
    for (std::size_t k = 0; store.isStraight && k < layers.size(); ++k) {
        how.format == ImageFormat::Png16 ? bleed<std::uint16_t>(layers[k].grid, out[k])
                                         : bleed<std::uint8_t>(layers[k].grid, out[k]);
    }
    return out;
}

} // namespace fumage
