// Included once per SIMD target: paints sprites with their noise texture, patch by patch.

#if defined(FUMAGE_TEXTURED_SPRITE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_TEXTURED_SPRITE_INL_H
#undef FUMAGE_TEXTURED_SPRITE_INL_H
#else
#define FUMAGE_TEXTURED_SPRITE_INL_H
#endif

#include "core/rendering/packed_dot-inl.h"
#include "core/rendering/tile-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Texture coordinates are fixed-point numbers: added to this, a float has 1/128 texel in its lowest bit, negative ones
/// in two's complement.
constexpr float kToFixed = 98304.0F;
constexpr int kFractionBits = 7;
/// Weights of the texels at fraction t are kFull - t and t: the last step before the next texel gives that texel, so
/// that no value jumps.
constexpr int kFull = (1 << kFractionBits) - 1;

/// How many lights shade the inside of a textured sprite: none, the sun, or that and those of other targets in place of
/// what lights evenly.
constexpr std::size_t kSunAlone = 1;

/// How one light shades the inside of a sprite.
struct LightOnSprite {
    float reliefU, reliefV; ///< by the noise's slope, per grey value * kFull
    float roundX, roundY; ///< by the place in the sprite, per pixel

    /// @param scale of the sprite's matrix without which it only turns @param slope relief of one grey value * kFull
    /// @param lightX,lightY its way; y runs down
    LightOnSprite(const SpriteStyle& style, const Sprite& sprite, float scale, float slope, float lightX, float lightY)
    {
        const float lightP = (sprite.m00 * lightX + sprite.m01 * lightY) * scale;
        const float lightQ = (sprite.m10 * lightX + sprite.m11 * lightY) * scale;
        reliefU = lightP * slope;
        reliefV = lightQ * slope;
        roundX = -(lightP * sprite.m00 + lightQ * sprite.m10) * style.roundness;
        roundY = -(lightP * sprite.m01 + lightQ * sprite.m11) * style.roundness;
    }
};

/// What a textured sprite needs for each of its pixels.
struct TexturedSprite {
    const std::uint32_t* texels;
    int shift; ///< log2 of the level's edge
    float texelsAcross, u, v;
    float leastAlpha, alphaScale, alphaShift; ///< of grey values 0..255 * kFull^2; at most the sprite's opacity
    float turn, slope; ///< what LightOnSprite takes

    TexturedSprite(const SpriteStyle& style, const SpriteTexture& texture, const Sprite& sprite)
    {
        const TextureRef ref = unpackTexture(sprite.texture);
        texels = texture.texels(ref.level, ref.slice);
        const int edge = texture.levelSize(ref.level);
        shift = std::countr_zero(static_cast<unsigned>(edge));
        texelsAcross = 0.5F * style.textureScale * static_cast<float>(edge);
        // Half a texel from edge to centre.
        u = static_cast<float>(ref.u) * (1.0F / 256.0F) * static_cast<float>(edge) - 0.5F;
        v = static_cast<float>(ref.v) * (1.0F / 256.0F) * static_cast<float>(edge) - 0.5F;
        // The noise takes its share of the opacity as it rises above the erosion; what it does not disturb stays.
        const float disturbed = sprite.opacity * style.texture;
        leastAlpha = sprite.opacity - disturbed;
        alphaScale = disturbed / (255.0F * style.erosionSoftness * static_cast<float>(kFull * kFull));
        alphaShift = leastAlpha - disturbed * ref.erosion / style.erosionSoftness;
        // The way of the light in the sprite: turned by its matrix without the scale.
        turn = 1.0F / std::sqrt(std::abs(sprite.m00 * sprite.m11 - sprite.m01 * sprite.m10));
        // A slope per texel times the texels across is one per radius, whatever the resolution.
        slope = style.relief * texelsAcross / static_cast<float>(255 * kFull);
    }
};

/// What a textured sprite has for each column and each row of its pixels in a tile; the rest is a sum or product of the
/// two.
struct SpriteLines {
    // Not initialised: that would cost more than the painting.
    // NOLINTBEGIN(cppcoreguidelines-avoid-c-arrays)
    struct Across {
        alignas(kAlignment) float dx[kLineRoom],
            bend[kLineRoom]; ///< of the profile: hardness (1 - r^2) = rest - dx (bend + slope)
        alignas(kAlignment) float u[kLineRoom], v[kLineRoom]; ///< texture coordinates
        alignas(kAlignment) float round[kTargetLights][kLineRoom]; ///< shading by each light
        alignas(kAlignment) float p[kLineRoom], q[kLineRoom]; ///< place in a square, in pixels across its edges
    } across;
    struct Down {
        alignas(kAlignment) float slope[kLineRoom], rest[kLineRoom];
        alignas(kAlignment) float u[kLineRoom], v[kLineRoom]; ///< with kToFixed
        alignas(kAlignment) float round[kTargetLights][kLineRoom];
        alignas(kAlignment) float p[kLineRoom], q[kLineRoom];
    } down;
    // NOLINTEND(cppcoreguidelines-avoid-c-arrays)
};

/// A square's half edges in pixels, along p and along q.
struct SquareRim {
    float p, q;

    explicit SquareRim(const Sprite& sprite)
        : p(1.0F / std::sqrt(sprite.m00 * sprite.m00 + sprite.m01 * sprite.m01))
        , q(1.0F / std::sqrt(sprite.m10 * sprite.m10 + sprite.m11 * sprite.m11))
    {
    }
};

/// What comes from the right goes to the left.
template <std::size_t kLights>
HWY_INLINE std::array<LightOnSprite, kLights> lightsOn(
    const SpriteStyle& style, const Sprite& sprite, const TexturedSprite& look)
{
    const auto light = [&](float x, float y) { return LightOnSprite(style, sprite, look.turn, look.slope, x, y); };
    if constexpr (kLights == 0) {
        return {};
    } else if constexpr (kLights == kSunAlone) {
        return {light(style.lightX, style.lightY)};
    } else {
        return {light(style.lightX, style.lightY), light(-1.0F, 0.0F), light(0.0F, 1.0F), light(1.0F, 0.0F),
            light(0.0F, -1.0F)};
    }
}

template <bool kSquare, std::size_t kLights>
HWY_INLINE void fillLines(const SpriteStyle& style, const Sprite& sprite, const TexturedSprite& look,
    const std::array<LightOnSprite, kLights>& lights, const Rim& rim, const SquareRim& edges, const Patches& box,
    const Tile& tile, SpriteLines& lines)
{
    const D d;
    const V bend = hn::Set(d, rim.xx * style.hardness);
    const V hardness = hn::Set(d, style.hardness);
    for (std::size_t part = 0; part < Tile::kPatchPixels; part += hn::Lanes(d)) {
        for (int column = box.left; column <= box.right; ++column) {
            const std::size_t at = static_cast<std::size_t>(column) * Tile::kPatchPixels + part;
            const V dx = fromCentre(d, kColumns + part, tile.left + column * Tile::kPatch, sprite.x);
            const auto store = [&](float* HWY_RESTRICT to, float slope) HWY_ATTR { hn::Store(slope * dx, d, to + at); };
            store(lines.across.u, sprite.m00 * look.texelsAcross);
            store(lines.across.v, sprite.m10 * look.texelsAcross);
            for (std::size_t i = 0; i < kLights; ++i) {
                store(lines.across.round[i], lights[i].roundX);
            }
            if constexpr (kSquare) {
                store(lines.across.p, sprite.m00 * edges.p);
                store(lines.across.q, sprite.m10 * edges.q);
            } else {
                hn::Store(dx, d, lines.across.dx + at);
                hn::Store(bend * dx, d, lines.across.bend + at);
            }
        }
        for (int row = box.top; row <= box.bottom; ++row) {
            const std::size_t at = static_cast<std::size_t>(row) * Tile::kPatchPixels + part;
            const V dy = fromCentre(d, kRows + part, tile.top + row * Tile::kPatch, sprite.y);
            const auto store = [&](float* HWY_RESTRICT to, float slope, float constant)
                                   HWY_ATTR { hn::Store(slope * dy + constant, d, to + at); };
            store(lines.down.u, sprite.m01 * look.texelsAcross, kToFixed + look.u);
            store(lines.down.v, sprite.m11 * look.texelsAcross, kToFixed + look.v);
            for (std::size_t i = 0; i < kLights; ++i) {
                store(lines.down.round[i], lights[i].roundY, 1.0F);
            }
            if constexpr (kSquare) {
                store(lines.down.p, sprite.m01 * edges.p, 0.0F);
                store(lines.down.q, sprite.m11 * edges.q, 0.0F);
            } else {
                store(lines.down.slope, 2.0F * rim.xy * style.hardness, 0.0F);
                hn::Store(hardness * (1.0F - rim.yy * dy * dy), d, lines.down.rest + at);
            }
        }
    }
}

/// @param kShaded its noise or its roundness is lit @param kManyTargets there are other targets
template <bool kSquare, bool kShaded, bool kManyTargets>
void paintTextured(const SpriteStyle& style, const SpriteTexture& texture, const Sprite& sprite,
    const SpriteInTargets& others, Tile& tile)
{
    const Patches box = patchesOf(sprite, tile);
    if (box.none()) {
        return;
    }
    const D d;
    const hn::RebindToSigned<D> di;
    const TexturedSprite look(style, texture, sprite);
    const Rim rim(sprite);
    const SquareRim edges(sprite);
    constexpr std::size_t kLights = !kShaded ? 0 : kManyTargets ? kTargetLights : kSunAlone;
    const std::array<LightOnSprite, kLights> lights = lightsOn<kLights>(style, sprite, look);
    SpriteLines lines;
    fillLines<kSquare, kLights>(style, sprite, look, lights, rim, edges, box, tile, lines);

    const I wrap = hn::Set(di, (1 << look.shift) - 1);
    // The fraction in all bytes or halves of a lane, then full minus fraction in the first of each two.
    const I fractionBytes = hn::Set(di, kFull * 0x01010101);
    const I fractionHalves = hn::Set(di, kFull * 0x00010001);
    const I firstHalf = hn::Set(di, kFull);
    const I rise = hn::Set(di, 0x01ff01ff); // +1 and -1 in bytes
    const I riseOfHalves = hn::Set(di, 0x0001ffff);
    const V zero = hn::Zero(d);
    // Half of a pixel that an edge runs through is inside.
    const V insideP = hn::Set(d, edges.p + kHalfEdge);
    const V insideQ = hn::Set(d, edges.q + kHalfEdge);
    const V alphaScale = hn::Set(d, look.alphaScale);
    const V alphaShift = hn::Set(d, look.alphaShift);
    const V leastAlpha = hn::Set(d, look.leastAlpha);
    const V mostAlpha = hn::Set(d, sprite.opacity);
    const V directRed = hn::Set(d, sprite.direct[0]);
    const V directGreen = hn::Set(d, sprite.direct[1]);
    const V directBlue = hn::Set(d, sprite.direct[2]);
    const V ambientRed = hn::Set(d, sprite.ambient[0]);
    const V ambientGreen = hn::Set(d, sprite.ambient[1]);
    const V ambientBlue = hn::Set(d, sprite.ambient[2]);
    const auto* texels = reinterpret_cast<const std::int32_t*>(look.texels);

    /// @param across,down of the vector's first pixel in the lists @param at its pixels in the tile @param more those
    /// in the other targets
    const auto paintVector = [&](std::size_t across, std::size_t down, float* HWY_RESTRICT at,
                                 float* HWY_RESTRICT more) HWY_ATTR {
        const auto sum = [&](const float* x, const float* y)
                             HWY_ATTR { return hn::Load(d, x + across) + hn::Load(d, y + down); };
        const I u = hn::BitCast(di, sum(lines.across.u, lines.down.u));
        const I v = hn::BitCast(di, sum(lines.across.v, lines.down.v));
        const I line = hn::ShiftLeftSame(hn::And(hn::ShiftRight<kFractionBits>(v), wrap), look.shift);
        const I footprint = hn::GatherIndex(di, texels, hn::Or(line, hn::And(hn::ShiftRight<kFractionBits>(u), wrap)));
        const I alongU = hn::Xor(hn::And(spreadLowestByte(di, u), fractionBytes), fractionHalves);
        const I alongV = hn::Xor(hn::And(spreadLowestByte(di, v), fractionHalves), firstHalf);
        V mask;
        if constexpr (kSquare) {
            const V p = sum(lines.across.p, lines.down.p);
            const V q = sum(lines.across.q, lines.down.q);
            // A product, so that a square of few pixels covers what a large one does: 4 r^2.
            mask = clamp01(d, insideP - hn::Abs(p)) * clamp01(d, insideQ - hn::Abs(q));
        } else {
            const V fall = hn::Load(d, lines.across.dx + across) * sum(lines.across.bend, lines.down.slope);
            const V inside = clamp01(d, hn::Load(d, lines.down.rest + down) - fall);
            mask = inside * inside;
        }
        const auto dot = [&](I x, I y) HWY_ATTR { return hn::ConvertTo(d, dotHalves(di, x, y)); };
        const I pairs = dotBytes(di, footprint, alongU);
        const V a = mask * hn::Min(hn::Max(dot(pairs, alongV) * alphaScale + alphaShift, leastAlpha), mostAlpha);
        if constexpr (kShaded) {
            const V slopeU = dot(dotBytes(di, footprint, rise), alongV);
            const V slopeV = dot(pairs, riseOfHalves);
            const auto shadeBy = [&](std::size_t i) HWY_ATTR {
                return hn::Max(zero,
                    lights[i].reliefV * slopeV
                        + (lights[i].reliefU * slopeU + sum(lines.across.round[i], lines.down.round[i])));
            };
            const V shade = shadeBy(0);
            const OwnColours own{
                shade * directRed + ambientRed, shade * directGreen + ambientGreen, shade * directBlue + ambientBlue};
            const V weight = under(d, at, a, own);
            if constexpr (kManyTargets) {
                const V shades[kTargetLights] = {hn::Set(d, 1.0F), shadeBy(kFromRight), shadeBy(kFromTop),
                    shadeBy(kFromLeft), shadeBy(kFromBottom)}; // NOLINT(cppcoreguidelines-avoid-c-arrays)
                others.under<true>(d, more, weight, own, shades);
            }
        } else {
            const OwnColours own{directRed + ambientRed, directGreen + ambientGreen, directBlue + ambientBlue};
            const V weight = under(d, at, a, own);
            if constexpr (kManyTargets) {
                others.under<false>(d, more, weight, own, nullptr);
            }
        }
    };
    const auto paintRow = [&](int row, int first, int last) HWY_ATTR {
        for (std::size_t part = 0; part < Tile::kPatchPixels; part += hn::Lanes(d)) {
            float* pixels = tile.patches.data() + patchOffset(first, row) + part;
            float* more = kManyTargets ? tile.others.data() + others.targets.offset(first, row) + part : nullptr;
            const std::size_t down = static_cast<std::size_t>(row) * Tile::kPatchPixels + part;
            for (int column = first; column <= last;
                 ++column, pixels += Tile::kPatchFloats, more += others.targets.stride()) {
                paintVector(static_cast<std::size_t>(column) * Tile::kPatchPixels + part, down, pixels, more);
            }
        }
    };
    if constexpr (kSquare) {
        for (int row = box.top; row <= box.bottom; ++row) {
            paintRow(row, box.left, box.right);
        }
    } else {
        forRows(sprite, rim, box, tile, paintRow);
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
