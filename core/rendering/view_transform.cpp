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

#include <glm/common.hpp>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;

constexpr float kHalfWhite = 12.0F; ///< light that filmic shows half as colourful as it is
constexpr float kWhitePoint = 96.0F; ///< light from which on all is white

HWY_INLINE V srgb(D d, V linear)
{
    const V bent =
        hn::Sub(hn::Mul(hn::Set(d, 1.055F), exponential(d, hn::Mul(logarithm(d, linear), hn::Set(d, 1.0F / 2.4F)))),
            hn::Set(d, 0.055F));
    return hn::IfThenElse(hn::Le(linear, hn::Set(d, 0.0031308F)), hn::Mul(linear, hn::Set(d, 12.92F)), bent);
}

HWY_INLINE V filmicCurve(D d, V x)
{
    const V top = hn::Mul(x, mulAdd(hn::Set(d, 2.51F), x, hn::Set(d, 0.03F)));
    const V bottom = mulAdd(x, mulAdd(hn::Set(d, 2.43F), x, hn::Set(d, 0.59F)), hn::Set(d, 0.14F));
    return hn::Div(top, bottom);
}

/// Colours of a vector of pixels, and what lies beside them.
struct Pixels {
    V r, g, b, a;

    static HWY_INLINE Pixels load(D d, const float* from)
    {
        Pixels out;
        hn::LoadInterleaved4(d, from, out.r, out.g, out.b, out.a);
        return out;
    }
    [[nodiscard]] HWY_INLINE V brightest() const { return hn::Max(hn::Max(r, g), b); }

    template <class Change>
    [[nodiscard]] HWY_INLINE Pixels each(const Change& change) const
    {
        return {change(r), change(g), change(b), a};
    }
};

/// Light as it is shown, linear in [0, 1]. The brightest channel takes the curve and the others keep their ratio to it,
/// so that no hue turns; what is far too bright goes over into white by even parts of it, which turns no hue either.
HWY_INLINE Pixels shownLight(D d, const Pixels& light, bool isFilmic)
{
    if (!isFilmic) {
        return light.each([d](V x) HWY_ATTR { return clamp01(d, x); });
    }
    constexpr float kNoLight = 1e-20F;
    const V most = hn::Max(light.brightest(), hn::Set(d, kNoLight));
    const V curved = clamp01(d, filmicCurve(d, hn::Min(most, hn::Set(d, kWhitePoint))));
    // Half of the way to white at kHalfWhite, all of it at kWhitePoint, and hardly any below 4, where fire is:
    // Reinhard's curve with a white point, of the fourth power.
    const V x = hn::Min(most, hn::Set(d, kWhitePoint)) * (1.0F / kHalfWhite);
    const V power = (x * x) * (x * x);
    constexpr float kSquareAtWhite = (kWhitePoint / kHalfWhite) * (kWhitePoint / kHalfWhite);
    constexpr float kPowerAtWhite = kSquareAtWhite * kSquareAtWhite;
    const V white = clamp01(d, power * (1.0F + power * (1.0F / (kPowerAtWhite * kPowerAtWhite))) / (1.0F + power));
    return light.each([&](V channel) HWY_ATTR {
        const V ratio = channel / most;
        return clamp01(d, curved * (ratio + white * (1.0F - ratio)));
    });
}

/// What is shown of count pixels of light, encoded.
HWY_INLINE void show(float* HWY_RESTRICT light, std::size_t count, bool isFilmic)
{
    const D d;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const Pixels shown = shownLight(d, Pixels::load(d, light + 4 * i), isFilmic).each([d](V x) HWY_ATTR {
            return clamp01(d, srgb(d, x));
        });
        hn::StoreInterleaved4(shown.r, shown.g, shown.b, shown.a, d, light + 4 * i);
    }
}

constexpr float kMinAlpha = 1e-6F;
constexpr float kLit = 1.0F; // as bright as smoke in the sun
constexpr float kBurning = 3.0F;

/// Raises the alpha of straight colours that cannot show the light there is.
/// @param shown room for the row
void coverLight(const float* HWY_RESTRICT from, std::size_t count, float gain, bool isFilmic, float* HWY_RESTRICT shown,
    float* HWY_RESTRICT straight)
{
    for (std::size_t i = 0; i < count * 4; ++i) {
        shown[i] = from[i] * gain;
    }
    show(shown, count, isFilmic);
    for (std::size_t i = 0; i < count; ++i, from += 4, shown += 4, straight += 4) {
        const float alpha = straight[3];
        const float brightest = std::max({shown[0], shown[1], shown[2]});
        const float colour = gain * std::max({from[0], from[1], from[2]}) / std::max(alpha, kMinAlpha);
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

/// Encodes one row of RGBA floats into floats in [0, 1], with straight alpha.
void encodeRow(
    const float* HWY_RESTRICT from, std::size_t count, float gain, bool isFilmic, float* HWY_RESTRICT straight)
{
    for (std::size_t i = 0; i < count; ++i) {
        const float alpha = from[i * 4 + 3];
        const float share = alpha > 0.0F ? gain / alpha : 0.0F;
        straight[i * 4] = from[i * 4] * share;
        straight[i * 4 + 1] = from[i * 4 + 1] * share;
        straight[i * 4 + 2] = from[i * 4 + 2] * share;
        straight[i * 4 + 3] = alpha;
    }
    show(straight, count, isFilmic);
}

/// Puts a row of RGBA floats over what is shown behind it, and encodes that.
/// @param behind linear light as it is shown, four floats a pixel, in [0, 1] @param out gets the row, opaque
void encodeRowOver(const float* HWY_RESTRICT from, const float* HWY_RESTRICT behind, std::size_t count, float gain,
    bool isFilmic, float* HWY_RESTRICT out)
{
    const D d;
    const V one = hn::Set(d, 1.0F);
    const V none = hn::Zero(d);
    std::copy_n(from, count * 4, out);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const Pixels smoke = Pixels::load(d, out + 4 * i);
        const Pixels back = Pixels::load(d, behind + 4 * i);
        const V alpha = clamp01(d, smoke.a);
        const Pixels light = smoke.each([gain](V x) HWY_ATTR { return x * gain; });
        // Smoke in the colour that transparent pictures have, and light as it is over black.
        const V thick = hn::Max(alpha, hn::Set(d, kMinAlpha));
        const Pixels straight = shownLight(d, light.each([thick](V x) HWY_ATTR { return x / thick; }), isFilmic);
        const Pixels glow = shownLight(d, light, isFilmic);
        const V brightest = glow.brightest();
        const V colour = light.brightest() / thick;
        constexpr float kWholly = 4.0F; // over the part of the light that alpha does not cover
        const V uncovered = clamp01(d, (brightest - alpha) / hn::Max(brightest, hn::Set(d, kMinAlpha)) * kWholly);
        const V share = uncovered * smoothStep(clamp01(d, (colour - kLit) * (1.0F / (kBurning - kLit))));
        const V through = one - (alpha + share * hn::Max(none, brightest - alpha));
        const auto over = [&](V plain, V bright, V rear) HWY_ATTR {
            const V covered = isFilmic ? plain * alpha : hn::Min(bright, alpha);
            return clamp01(d, srgb(d, covered + share * (bright - covered) + rear * through));
        };
        hn::StoreInterleaved4(over(straight.r, glow.r, back.r), over(straight.g, glow.g, back.g),
            over(straight.b, glow.b, back.b), one, d, out + 4 * i);
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(encodeRow);
HWY_EXPORT(coverLight);
HWY_EXPORT(encodeRowOver);

namespace {

constexpr std::size_t kPadding = kAlignment;

/// Calls encodeLine(y, line) for each row, which puts RGBA floats in [0, 1] into the line, and writes them into the
/// picture.
template <class Channel, class EncodeLine>
void encodeLines(const Image& image, EncodedImage<Channel>& out, const EncodeLine& encodeLine)
{
    constexpr auto kFull = static_cast<float>(std::numeric_limits<Channel>::max());
    const auto width = static_cast<std::size_t>(image.width);
    out.width = image.width;
    out.height = image.height;
    out.pixels.resize(width * static_cast<std::size_t>(image.height) * 4);
    parallelFor(static_cast<std::size_t>(image.height), [&](std::size_t y) {
        AlignedArray<float> line(width * 4 + kPadding);
        encodeLine(static_cast<int>(y), line.data());
        Channel* to = out.pixels.data() + y * width * 4;
        for (std::size_t i = 0; i < width * 4; ++i) {
            to[i] = static_cast<Channel>(static_cast<int>(line[i] * kFull + 0.5F));
        }
    });
}

/// @param line four floats a pixel
void fillLine(const Backing& backing, int y, std::size_t width, float* line)
{
    for (std::size_t x = 0; x < width; ++x) {
        const bool isOther = backing.square > 0 && (static_cast<int>(x) / backing.square + y / backing.square) % 2 != 0;
        const glm::vec3 colour = glm::clamp(isOther ? backing.other : backing.colour, 0.0F, 1.0F);
        std::copy_n(&colour.x, 3, line + 4 * x);
    }
}

template <class Channel>
void encodeAllOver(const Image& image, const Output& output, const Backing& backing, EncodedImage<Channel>& out)
{
    const auto width = static_cast<std::size_t>(image.width);
    const float gain = exposureGain(output.exposure);
    encodeLines(image, out, [&](int y, float* line) {
        AlignedArray<float> behind(width * 4 + kPadding);
        fillLine(backing, y, width, behind.data());
        HWY_DYNAMIC_DISPATCH(encodeRowOver)
        (image.row(y), behind.data(), width, gain, output.viewTransform == ViewTransform::Filmic, line);
    });
}

template <class Channel>
void encodeAll(const Image& image, const Output& output, EncodedImage<Channel>& out, Cover cover)
{
    if (output.background == Background::Colour) {
        encodeAllOver(image, output, {output.backgroundColour}, out);
        return;
    }
    const auto width = static_cast<std::size_t>(image.width);
    const float gain = exposureGain(output.exposure);
    const bool isFilmic = output.viewTransform == ViewTransform::Filmic;
    encodeLines(image, out, [&](int y, float* line) {
        HWY_DYNAMIC_DISPATCH(encodeRow)
        (image.row(y), width, gain, isFilmic, line);
        if (cover == Cover::Light) {
            AlignedArray<float> shown(width * 4 + kPadding);
            HWY_DYNAMIC_DISPATCH(coverLight)
            (image.row(y), width, gain, isFilmic, shown.data(), line);
        }
    });
}

} // namespace

Cover coverOf(const Glow& glow)
{
    return hasClearFlames(glow) ? Cover::Light : Cover::Alpha;
}

Cover coverOf(const Scene& scene)
{
    const std::vector<std::size_t> seen = scene.visibleLayers();
    const bool byLight = std::any_of(
        seen.begin(), seen.end(), [&](std::size_t layer) { return coverOf(scene.layers[layer].glow) == Cover::Light; });
    return byLight ? Cover::Light : Cover::Alpha;
}

void encode(const Image& image, const Output& output, EncodedImage<std::uint8_t>& out, Cover cover)
{
    encodeAll(image, output, out, cover);
}

void encode(const Image& image, const Output& output, EncodedImage<std::uint16_t>& out, Cover cover)
{
    encodeAll(image, output, out, cover);
}

void encodeOver(const Image& image, const Output& output, const Backing& backing, EncodedImage<std::uint8_t>& out)
{
    encodeAllOver(image, output, backing, out);
}

float brightestShown(const Output& output)
{
    // Where the filmic curve, x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14), comes to 1: the positive root of 0.08 x^2
    // - 0.56 x - 0.14.
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
