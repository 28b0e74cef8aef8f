// Included once per SIMD target: paints sprites with their noise texture, strip by strip.

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

/// A rim that can be solved row by row.
struct Ellipse : Rim {
    float slant; ///< centre of a row moves by this for each dy
    float height; ///< yy without the slant
    float halfRoot; ///< half width of the middle row

    explicit Ellipse(const Sprite& s)
        : Rim(s)
        , slant(-xy / xx)
        , height(yy + xy * slant)
        , halfRoot(1.0F / std::sqrt(xx))
    {
    }
};

/// Texture coordinates are fixed-point numbers: added to this, a float has 1/128 texel in its lowest bit, negative ones in two's complement.
constexpr float kToFixed = 98304.0F;
constexpr int kFractionBits = 7;
/// Weights of the texels at fraction t are kFull - t and t: the last step before the next texel gives that texel, so that no value jumps.
constexpr int kFull = (1 << kFractionBits) - 1;

/// What a textured sprite needs for each of its pixels.
struct TexturedSprite {
    const std::uint32_t* texels;
    int shift; ///< log2 of the level's edge
    float texelsAcross, u, v;
    float leastAlpha, alphaScale, alphaShift; ///< of grey values 0..255 * kFull^2; at most the sprite's opacity
    float reliefU, reliefV; ///< shading by the noise's slope, per grey value * kFull
    float roundX, roundY; ///< shading by the place in the sprite, per pixel

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
        const float scale = 1.0F / std::sqrt(std::abs(sprite.m00 * sprite.m11 - sprite.m01 * sprite.m10));
        const float lightP = (sprite.m00 * style.lightX + sprite.m01 * style.lightY) * scale;
        const float lightQ = (sprite.m10 * style.lightX + sprite.m11 * style.lightY) * scale;
        // A slope per texel times the texels across is one per radius, whatever the resolution.
        const float slope = style.relief * texelsAcross / static_cast<float>(255 * kFull);
        reliefU = lightP * slope;
        reliefV = lightQ * slope;
        roundX = -(lightP * sprite.m00 + lightQ * sprite.m10) * style.roundness;
        roundY = -(lightP * sprite.m01 + lightQ * sprite.m11) * style.roundness;
    }
};

/// A vector of pixels in a pair of rows.
struct Strip {
    float x; ///< of the first pixel
    std::uint32_t row; ///< the first of the two, counted from the top of the sprite in the tile
    std::size_t offset; ///< into the planes
};

/// The strips of a sprite in a tile, one after the other: one loop over them has one end, where rows would each have theirs.
struct StripList {
    static constexpr std::size_t kMost = kRowRoom / 2 * static_cast<std::size_t>(Compositor::kTileWidth) + 1;

    // Not initialised: that would cost more than the painting.
    // NOLINTBEGIN(cppcoreguidelines-avoid-c-arrays)
    std::size_t count = 0;
    Strip strips[kMost];
    // One value a row, at dx = 0.
    alignas(kAlignment) float u[kRowRoom], v[kRowRoom]; ///< texture coordinates with kToFixed
    alignas(kAlignment) float round[kRowRoom]; ///< shading
    alignas(kAlignment) float slope[kRowRoom], rest[kRowRoom]; ///< of the profile: hardness (1 - r^2) = rest - dx (bend dx + slope)
    alignas(kAlignment) float p[kRowRoom], q[kRowRoom]; ///< place in the sprite
    // One value a pair of rows.
    alignas(kAlignment) std::int32_t first[kRowRoom / 2], last[kRowRoom / 2]; ///< columns of the image
    // NOLINTEND(cppcoreguidelines-avoid-c-arrays)
};

template <bool kSquare>
HWY_INLINE void fillRows(const SpriteStyle& style, const Sprite& sprite, const TexturedSprite& look, const Ellipse& ellipse, const Box& box, StripList& list)
{
    const D d;
    const std::size_t rows = roundUp(static_cast<std::size_t>(box.bottom - box.top + 1), 2);
    const V hardness = hn::Set(d, style.hardness);
    for (std::size_t i = 0; i < rows; i += hn::Lanes(d)) {
        const V dy = rowOffsets(d, box.top + static_cast<int>(i), 1.0F, sprite.y);
        const auto store = [&](float* HWY_RESTRICT to, float slope, float constant) HWY_ATTR { hn::Store(mulAdd(hn::Set(d, slope), dy, hn::Set(d, constant)), d, to + i); };
        store(list.u, sprite.m01 * look.texelsAcross, kToFixed + look.u);
        store(list.v, sprite.m11 * look.texelsAcross, kToFixed + look.v);
        store(list.round, look.roundY, 1.0F);
        if constexpr (kSquare) {
            store(list.p, sprite.m01, 0.0F);
            store(list.q, sprite.m11, 0.0F);
        } else {
            store(list.slope, 2.0F * ellipse.xy * style.hardness, 0.0F);
            hn::Store(hn::Mul(hardness, hn::Sub(hn::Set(d, 1.0F), hn::Mul(hn::Mul(hn::Set(d, ellipse.yy), dy), dy))), d, list.rest + i);
        }
    }
}

/// Columns that pairs of rows of an ellipse cover; from a whole vector on, so that loads and stores do not straddle cache lines: the mask leaves
/// out what lies before the rim.
HWY_INLINE void fillEnds(const Sprite& sprite, const Ellipse& ellipse, const Box& box, const Tile& tile, StripList& list)
{
    const D d;
    const hn::RebindToSigned<D> di;
    const auto pairs = static_cast<std::size_t>(box.bottom - box.top) / 2 + 1;
    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0F);
    const auto left = hn::Set(di, tile.left);
    for (std::size_t i = 0; i < pairs; i += hn::Lanes(d)) {
        const V dy = rowOffsets(d, box.top + 2 * static_cast<int>(i), 2.0F, sprite.y);
        // The rows are as wide together as the wider one, and the lean of the ellipse moves one against the other.
        const V nearest = hn::IfThenElse(hn::Gt(dy, zero), dy, hn::Min(zero, hn::Add(dy, one)));
        const V root = hn::Sqrt(hn::Max(zero, hn::Sub(one, hn::Mul(hn::Set(d, ellipse.height), hn::Mul(nearest, nearest)))));
        const V half = mulAdd(hn::Set(d, ellipse.halfRoot), root, hn::Set(d, 0.5F * std::abs(ellipse.slant)));
        const V middle = mulAdd(hn::Set(d, ellipse.slant), hn::Add(dy, hn::Set(d, 0.5F)), hn::Set(d, sprite.x - 0.5F));
        const auto first = hn::Max(hn::Set(di, box.left), hn::ConvertTo(di, hn::Ceil(hn::Sub(middle, half))));
        const auto last = hn::Min(hn::Set(di, box.right), hn::ConvertTo(di, hn::Floor(hn::Add(middle, half))));
        const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
        hn::Store(hn::Add(left, hn::And(hn::Sub(first, left), hn::Set(di, -lanes))), di, list.first + i);
        hn::Store(last, di, list.last + i);
    }
}

template <bool kSquare>
HWY_INLINE void listStrips(const SpriteStyle& style, const Sprite& sprite, const TexturedSprite& look, const Ellipse& ellipse, const Tile& tile, StripList& list)
{
    const Box box = boxOf(sprite, tile);
    if (box.bottom < box.top || box.right < box.left) {
        return;
    }
    const int lanes = static_cast<int>(hn::Lanes(D()));
    fillRows<kSquare>(style, sprite, look, ellipse, box, list);
    const bool whole = kSquare || box.right - box.left < lanes;
    if (!whole) {
        fillEnds(sprite, ellipse, box, tile, list);
    }
    for (int y = box.top, pair = 0; y <= box.bottom; y += 2, ++pair) {
        const int first = whole ? box.left : list.first[pair];
        const int last = whole ? box.right : list.last[pair];
        for (int x = first; x <= last; x += lanes) {
            list.strips[list.count++] = {static_cast<float>(x), static_cast<std::uint32_t>(2 * pair), tileOffset(tile, x, y)};
        }
    }
}

/// What the two rows of a strip have in one of the lists.
HWY_INLINE Rows broadcast(D d, const float* HWY_RESTRICT values)
{
    return {hn::Set(d, values[0]), hn::Set(d, values[1])};
}

/// What has been read of the texture for a strip, and the weights of the texels: along u in bytes, along v in halves.
struct Fetched {
    using I = hn::Vec<hn::RebindToSigned<D>>;
    RowsOf<I> texels, alongU, alongV;
};

template <bool kSquare, bool kShaded>
void paintTextured(const SpriteStyle& style, const SpriteTexture& texture, const Sprite& sprite, Tile& tile)
{
    const D d;
    const hn::RebindToSigned<D> di;
    const TexturedSprite look(style, texture, sprite);
    const Ellipse ellipse(sprite);
    StripList list;
    listStrips<kSquare>(style, sprite, look, ellipse, tile, list);
    if (list.count == 0) {
        return;
    }
    list.strips[list.count] = list.strips[list.count - 1]; // fetched ahead, not painted

    using I = Fetched::I;
    const I wrap = hn::Set(di, (1 << look.shift) - 1);
    // The fraction in all bytes or halves of a lane, then full minus fraction in the first of each two.
    const I fractionBytes = hn::Set(di, kFull * 0x01010101);
    const I fractionHalves = hn::Set(di, kFull * 0x00010001);
    const I firstHalf = hn::Set(di, kFull);
    const I rise = hn::Set(di, 0x01ff01ff); // +1 and -1 in bytes
    const I riseOfHalves = hn::Set(di, 0x0001ffff);
    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0F);
    const V halves = hn::Iota(d, 0.5F);
    const V centre = hn::Set(d, sprite.x);
    const V bend = hn::Set(d, ellipse.xx * style.hardness);
    const V alongU = hn::Set(d, sprite.m00 * look.texelsAcross);
    const V alongV = hn::Set(d, sprite.m10 * look.texelsAcross);
    const V alongRound = hn::Set(d, look.roundX);
    const V alphaScale = hn::Set(d, look.alphaScale);
    const V alphaShift = hn::Set(d, look.alphaShift);
    const V leastAlpha = hn::Set(d, look.leastAlpha);
    const V mostAlpha = hn::Set(d, sprite.opacity);
    const V reliefU = hn::Set(d, look.reliefU);
    const V reliefV = hn::Set(d, look.reliefV);
    const V directRed = hn::Set(d, sprite.direct[0]);
    const V directGreen = hn::Set(d, sprite.direct[1]);
    const V directBlue = hn::Set(d, sprite.direct[2]);
    const V ambientRed = hn::Set(d, sprite.ambient[0]);
    const V ambientGreen = hn::Set(d, sprite.ambient[1]);
    const V ambientBlue = hn::Set(d, sprite.ambient[2]);
    const auto* texels = reinterpret_cast<const std::int32_t*>(look.texels);

    const auto fetch = [&](const Strip& strip) HWY_ATTR {
        const V dx = hn::Sub(hn::Add(halves, hn::Set(d, strip.x)), centre);
        const Rows u = both(hn::Mul(alongU, dx)) + broadcast(d, list.u + strip.row);
        const Rows v = both(hn::Mul(alongV, dx)) + broadcast(d, list.v + strip.row);
        const auto read = [&](V column, V row, I& texel, I& weightU, I& weightV) HWY_ATTR {
            const I fixedU = hn::BitCast(di, column);
            const I fixedV = hn::BitCast(di, row);
            const I line = hn::ShiftLeftSame(hn::And(hn::ShiftRight<kFractionBits>(fixedV), wrap), look.shift);
            texel = hn::GatherIndex(di, texels, hn::Or(line, hn::And(hn::ShiftRight<kFractionBits>(fixedU), wrap)));
            weightU = hn::Xor(hn::And(spreadLowestByte(di, fixedU), fractionBytes), fractionHalves);
            weightV = hn::Xor(hn::And(spreadLowestByte(di, fixedV), fractionHalves), firstHalf);
        };
        Fetched out;
        read(u.a, v.a, out.texels.a, out.alongU.a, out.alongV.a);
        read(u.b, v.b, out.texels.b, out.alongU.b, out.alongV.b);
        return out;
    };

    // The texture is read one strip ahead: while it comes, there is the strip before to blend.
    Fetched next = fetch(list.strips[0]);
    for (std::size_t i = 0; i < list.count; ++i) {
        const Fetched now = next;
        next = fetch(list.strips[i + 1]);
        const Strip& strip = list.strips[i];
        const V dx = hn::Sub(hn::Add(halves, hn::Set(d, strip.x)), centre);
        Rows mask;
        if constexpr (kSquare) {
            const Rows p = both(hn::Mul(hn::Set(d, sprite.m00), dx)) + broadcast(d, list.p + strip.row);
            const Rows q = both(hn::Mul(hn::Set(d, sprite.m10), dx)) + broadcast(d, list.q + strip.row);
            mask = {hn::IfThenElseZero(hn::Lt(hn::Max(hn::Abs(p.a), hn::Abs(q.a)), one), one), hn::IfThenElseZero(hn::Lt(hn::Max(hn::Abs(p.b), hn::Abs(q.b)), one), one)};
        } else {
            const Rows inside = clampRows(broadcast(d, list.rest + strip.row) - both(dx) * (both(hn::Mul(bend, dx)) + broadcast(d, list.slope + strip.row)), zero, one);
            mask = inside * inside;
        }
        const auto dots = [&](const RowsOf<I>& x, const RowsOf<I>& y) HWY_ATTR { return Rows{hn::ConvertTo(d, dotHalves(di, x.a, y.a)), hn::ConvertTo(d, dotHalves(di, x.b, y.b))}; };
        const RowsOf<I> lines{dotBytes(di, now.texels.a, now.alongU.a), dotBytes(di, now.texels.b, now.alongU.b)};
        const Rows grey = dots(lines, now.alongV);
        const Rows a = mask * clampRows(grey * both(alphaScale) + both(alphaShift), leastAlpha, mostAlpha);
        float* at = tile.planes.data() + strip.offset;
        if constexpr (kShaded) {
            const RowsOf<I> rises{dotBytes(di, now.texels.a, rise), dotBytes(di, now.texels.b, rise)};
            const Rows slopeU = dots(rises, now.alongV);
            const Rows slopeV = dots(lines, both(riseOfHalves));
            Rows shade = both(hn::Mul(alongRound, dx)) + broadcast(d, list.round + strip.row);
            shade = both(reliefV) * slopeV + (both(reliefU) * slopeU + shade);
            shade = {hn::Max(shade.a, zero), hn::Max(shade.b, zero)};
            under(d, at, a.a, mulAdd(shade.a, directRed, ambientRed), mulAdd(shade.a, directGreen, ambientGreen), mulAdd(shade.a, directBlue, ambientBlue));
            under(d, at + Tile::kStride, a.b, mulAdd(shade.b, directRed, ambientRed), mulAdd(shade.b, directGreen, ambientGreen), mulAdd(shade.b, directBlue, ambientBlue));
        } else {
            under(d, at, a.a, hn::Add(directRed, ambientRed), hn::Add(directGreen, ambientGreen), hn::Add(directBlue, ambientBlue));
            under(d, at + Tile::kStride, a.b, hn::Add(directRed, ambientRed), hn::Add(directGreen, ambientGreen), hn::Add(directBlue, ambientBlue));
        }
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
