#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/rendering/view_transform.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/math-inl.h"
#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/lighting/glow.h"
#include "core/rendering/view_transform.h"

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;

HWY_INLINE V srgb(D d, V linear)
{
    const V bent = hn::Sub(hn::Mul(hn::Set(d, 1.055F), exponential(d, hn::Mul(logarithm(d, linear), hn::Set(d, 1.0F / 2.4F)))), hn::Set(d, 0.055F));
    return hn::IfThenElse(hn::Le(linear, hn::Set(d, 0.0031308F)), hn::Mul(linear, hn::Set(d, 12.92F)), bent);
}

HWY_INLINE V filmic(D d, V x)
{
    const V top = hn::Mul(x, mulAdd(hn::Set(d, 2.51F), x, hn::Set(d, 0.03F)));
    const V bottom = mulAdd(x, mulAdd(hn::Set(d, 2.43F), x, hn::Set(d, 0.59F)), hn::Set(d, 0.14F));
    return hn::Div(top, bottom);
}

/// What is shown of count numbers of light.
HWY_INLINE void show(float* HWY_RESTRICT light, std::size_t count, bool isFilmic)
{
    const D d;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const V linear = hn::LoadU(d, light + i);
        hn::StoreU(clamp01(d, srgb(d, isFilmic ? filmic(d, linear) : linear)), d, light + i);
    }
}

/// Raises the alpha of straight colours that cannot show the light there is.
/// @param shown room for the row
void coverLight(const float* HWY_RESTRICT from, std::size_t count, float gain, bool isFilmic, float* HWY_RESTRICT shown, float* HWY_RESTRICT straight)
{
    for (std::size_t i = 0; i < count * 4; ++i) {
        shown[i] = from[i] * gain;
    }
    show(shown, count * 4, isFilmic);
    constexpr float kLeastAlpha = 1e-6F;
    constexpr float kLit = 1.0F; // as bright as smoke in the sun
    constexpr float kBurning = 3.0F;
    for (std::size_t i = 0; i < count; ++i, from += 4, shown += 4, straight += 4) {
        const float alpha = straight[3];
        const float brightest = std::max({shown[0], shown[1], shown[2]});
        const float colour = gain * std::max({from[0], from[1], from[2]}) / std::max(alpha, kLeastAlpha);
        if (!(brightest > alpha) || colour <= kLit) {
            continue;
        }
        const float share = fumage::smoothStep(std::min(1.0F, (colour - kLit) / (kBurning - kLit)));
        const float cover = alpha + share * (brightest - alpha);
        for (int channel = 0; channel < 3; ++channel) {
            const float covered = straight[channel] * alpha;
            straight[channel] = std::min(1.0F, (covered + share * (shown[channel] - covered)) / cover);
        }
        straight[3] = cover;
    }
}

/// Encodes one row of RGBA floats into floats in [0, 1]; all channels go through the same operations and alpha is put back.
void encodeRow(const float* HWY_RESTRICT from, std::size_t count, float gain, bool isFilmic, float* HWY_RESTRICT straight)
{
    for (std::size_t i = 0; i < count; ++i) {
        const float alpha = from[i * 4 + 3];
        const float share = alpha > 0.0F ? gain / alpha : 0.0F;
        straight[i * 4] = from[i * 4] * share;
        straight[i * 4 + 1] = from[i * 4 + 1] * share;
        straight[i * 4 + 2] = from[i * 4 + 2] * share;
        straight[i * 4 + 3] = 0.0F;
    }
    show(straight, count * 4, isFilmic);
    for (std::size_t i = 0; i < count; ++i) {
        straight[i * 4 + 3] = from[i * 4 + 3];
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(encodeRow);
HWY_EXPORT(coverLight);

namespace {

template <class Channel>
void encodeAll(const Image& image, const Output& output, EncodedImage<Channel>& out, Cover cover)
{
    constexpr std::size_t kPadding = kAlignment;
    constexpr auto kFull = static_cast<float>(std::numeric_limits<Channel>::max());
    const auto width = static_cast<std::size_t>(image.width);
    const float gain = exposureGain(output.exposure);
    out.width = image.width;
    out.height = image.height;
    out.pixels.resize(width * static_cast<std::size_t>(image.height) * 4);
    parallelFor(static_cast<std::size_t>(image.height), [&](std::size_t y) {
        AlignedArray<float> line(width * 4 + kPadding);
        const auto kernel = HWY_DYNAMIC_DISPATCH(encodeRow);
        kernel(image.row(static_cast<int>(y)), width, gain, output.viewTransform == ViewTransform::Filmic, line.data());
        if (cover == Cover::Light) {
            AlignedArray<float> shown(width * 4 + kPadding);
            HWY_DYNAMIC_DISPATCH(coverLight)
            (image.row(static_cast<int>(y)), width, gain, output.viewTransform == ViewTransform::Filmic, shown.data(), line.data());
        }
        Channel* to = out.pixels.data() + y * width * 4;
        for (std::size_t i = 0; i < width * 4; ++i) {
            to[i] = static_cast<Channel>(static_cast<int>(line[i] * kFull + 0.5F));
        }
    });
}

} // namespace

Cover coverOf(const Light& light)
{
    return hasClearFlames(light) ? Cover::Light : Cover::Alpha;
}

void encode(const Image& image, const Output& output, EncodedImage<std::uint8_t>& out, Cover cover)
{
    encodeAll(image, output, out, cover);
}

void encode(const Image& image, const Output& output, EncodedImage<std::uint16_t>& out, Cover cover)
{
    encodeAll(image, output, out, cover);
}

float brightestShown(const Output& output)
{
    // Where the filmic curve, x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14), comes to 1: the positive root of 0.08 x^2 - 0.56 x - 0.14.
    constexpr float kFilmic = 7.24166F;
    return (output.viewTransform == ViewTransform::Filmic ? kFilmic : 1.0F) / exposureGain(output.exposure);
}

float exposureGain(float stops)
{
    constexpr float kLnTwo = 0.693147180559945309F;
    return portableExp(stops * kLnTwo);
}

float srgbFromLinear(float linear)
{
    return linear <= 0.0031308F ? 12.92F * linear : 1.055F * portablePow(linear, 1.0F / 2.4F) - 0.055F;
}

float linearFromSrgb(float encoded)
{
    return encoded <= 0.04045F ? encoded / 12.92F : portablePow((encoded + 0.055F) / 1.055F, 2.4F);
}

} // namespace fumage
#endif
