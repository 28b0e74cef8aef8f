#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/rendering/tile_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "core/base/math-inl.h"
#include "core/rendering/packed_dot-inl.h"
#include "core/rendering/tile_kernel.h"

#include <algorithm>
#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;

/// Rows and columns of the tile inside the box of a sprite; pixel centres lie at halves.
struct Box {
    int left, right, top, bottom; ///< inclusive
};

HWY_INLINE Box boxOf(const Sprite& sprite, const Tile& tile)
{
    const auto first = [](float edge) { return static_cast<int>(std::ceil(edge - 0.5F)); };
    const auto last = [](float edge) { return static_cast<int>(std::floor(edge - 0.5F)); };
    return {std::max(tile.left, first(std::max(sprite.x - sprite.halfWidth, -1e6F))), std::min(tile.right - 1, last(std::min(sprite.x + sprite.halfWidth, 1e6F))),
        std::max(tile.top, first(std::max(sprite.y - sprite.halfHeight, -1e6F))), std::min(tile.bottom - 1, last(std::min(sprite.y + sprite.halfHeight, 1e6F)))};
}

/// The rim p^2 + q^2 = 1 as xx dx^2 + 2 xy dx dy + yy dy^2 = 1.
struct Rim {
    float xx, xy, yy;

    explicit Rim(const Sprite& s)
        : xx(s.m00 * s.m00 + s.m10 * s.m10)
        , xy(s.m00 * s.m01 + s.m10 * s.m11)
        , yy(s.m01 * s.m01 + s.m11 * s.m11)
    {
    }
};

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

/// Adds a layer of opacity a and colour c under what is there.
template <class Tag, class W = hn::Vec<Tag>>
HWY_INLINE void under(Tag d, float* HWY_RESTRICT through, W a, W red, W green, W blue)
{
    float* HWY_RESTRICT toRed = through + Tile::kPixels;
    float* HWY_RESTRICT toGreen = through + 2 * Tile::kPixels;
    float* HWY_RESTRICT toBlue = through + 3 * Tile::kPixels;
    const W before = hn::LoadU(d, through);
    const W weight = hn::Mul(a, before);
    hn::StoreU(mulAdd(weight, red, hn::LoadU(d, toRed)), d, toRed);
    hn::StoreU(mulAdd(weight, green, hn::LoadU(d, toGreen)), d, toGreen);
    hn::StoreU(mulAdd(weight, blue, hn::LoadU(d, toBlue)), d, toBlue);
    hn::StoreU(hn::Sub(before, weight), d, through);
}

HWY_INLINE std::size_t tileOffset(const Tile& tile, int x, int y)
{
    return static_cast<std::size_t>(y - tile.top) * Tile::kStride + static_cast<std::size_t>(x - tile.left);
}

/// The same vector of pixels in two neighbouring rows: twice the independent work for a chain of operations that wait for one another.
template <class W>
struct RowsOf {
    W a, b;
};
using Rows = RowsOf<V>;

template <class W>
HWY_INLINE RowsOf<W> both(W v)
{
    return {v, v};
}

template <class W>
HWY_INLINE RowsOf<W> operator+(RowsOf<W> x, RowsOf<W> y)
{
    return {hn::Add(x.a, y.a), hn::Add(x.b, y.b)};
}

template <class W>
HWY_INLINE RowsOf<W> operator-(RowsOf<W> x, RowsOf<W> y)
{
    return {hn::Sub(x.a, y.a), hn::Sub(x.b, y.b)};
}

template <class W>
HWY_INLINE RowsOf<W> operator*(RowsOf<W> x, RowsOf<W> y)
{
    return {hn::Mul(x.a, y.a), hn::Mul(x.b, y.b)};
}

template <class W>
HWY_INLINE RowsOf<W> clampRows(RowsOf<W> x, W low, W high)
{
    return {hn::Min(hn::Max(x.a, low), high), hn::Min(hn::Max(x.b, low), high)};
}

/// dy of rows y, y + step, y + 2 step, ...; exact before the subtraction, so that they do not depend on the vector's width.
HWY_INLINE V rowOffsets(D d, int y, float step, float centre)
{
    return hn::Sub(hn::Add(hn::Mul(hn::Iota(d, 0.0F), hn::Set(d, step)), hn::Set(d, static_cast<float>(y) + 0.5F)), hn::Set(d, centre));
}

/// Room for one value a row of a tile, and for a pair of rows and a vector that run past its end.
constexpr std::size_t kRowRoom = roundUp(static_cast<std::size_t>(Compositor::kTileHeight) + 2, kAlignment / sizeof(float));

/// The profile of a sprite that is too small for its texture: alpha = (rest - dx (bend dx + slope))^2, where rest and slope change with the row.
/// All have the root of the opacity in them.
struct PlainProfile {
    float bend, lean, yy, scale, highest;

    PlainProfile(const SpriteStyle& style, const Sprite& sprite)
    {
        const Rim rim(sprite);
        highest = std::sqrt(sprite.opacity);
        scale = style.hardness * highest;
        bend = rim.xx * scale;
        lean = 2.0F * rim.xy * scale;
        yy = rim.yy;
    }
};

/// @param rowOf vectors of rest and slope of a row, counted from the box's top
/// @param kLean the rim is no circle @param kFlat the profile reaches its full height before the centre
template <bool kLean, bool kFlat, class Tag, class RowOf>
HWY_INLINE void paintColumns(Tag d, const Sprite& sprite, const Box& box, const PlainProfile& profile, const RowOf& rowOf, Tile& tile)
{
    using W = hn::Vec<Tag>;
    const W red = hn::Set(d, sprite.direct[0] + sprite.ambient[0]);
    const W green = hn::Set(d, sprite.direct[1] + sprite.ambient[1]);
    const W blue = hn::Set(d, sprite.direct[2] + sprite.ambient[2]);
    const W zero = hn::Zero(d);
    const W most = hn::Set(d, profile.highest);
    const W bend = hn::Set(d, profile.bend);
    const W firstColumn = hn::Iota(d, 0.5F);
    const W centre = hn::Set(d, sprite.x);
    const int lanes = static_cast<int>(hn::Lanes(d));
    const int rows = box.bottom - box.top + 1;
    for (int x = box.left; x <= box.right; x += lanes) {
        const W dx = hn::Sub(hn::Add(firstColumn, hn::Set(d, static_cast<float>(x))), centre);
        const W curve = hn::Mul(bend, hn::Mul(dx, dx));
        float* at = tile.planes.data() + tileOffset(tile, x, box.top);
        for (int row = 0; row < rows; ++row, at += Tile::kStride) {
            const RowsOf<W> line = rowOf(row);
            W root = hn::Sub(line.a, curve);
            if constexpr (kLean) {
                root = hn::Sub(root, hn::Mul(line.b, dx));
            }
            root = hn::Max(root, zero);
            if constexpr (kFlat) {
                root = hn::Min(root, most);
            }
            under(d, at, hn::Mul(root, root), red, green, blue);
        }
    }
}

/// A sprite too small for its texture: a soft disc of one colour.
template <bool kLean, bool kFlat>
void paintPlain(const SpriteStyle& style, const Sprite& sprite, Tile& tile)
{
    const Box box = boxOf(sprite, tile);
    const PlainProfile profile(style, sprite);
    // Over a narrow sprite a wide vector would blend mostly nothing, and lists of its rows would take longer than they save.
    constexpr float kNarrow = 5.0F;
    if (sprite.halfWidth < kNarrow) {
        const hn::CappedTag<float, 8> d;
        const float top = static_cast<float>(box.top) + 0.5F;
        const auto rowOf = [&](int row) HWY_ATTR {
            const float dy = (static_cast<float>(row) + top) - sprite.y;
            return RowsOf<hn::Vec<decltype(d)>>{hn::Set(d, profile.scale * (1.0F - profile.yy * (dy * dy))), hn::Set(d, profile.lean * dy)};
        };
        paintColumns<kLean, kFlat>(d, sprite, box, profile, rowOf, tile);
        return;
    }
    const D d;
    alignas(kAlignment) float rest[kRowRoom]; // NOLINT(cppcoreguidelines-avoid-c-arrays): not initialised
    alignas(kAlignment) float slope[kRowRoom]; // NOLINT(cppcoreguidelines-avoid-c-arrays)
    for (int i = 0; i <= box.bottom - box.top; i += static_cast<int>(hn::Lanes(d))) {
        const V dy = rowOffsets(d, box.top + i, 1.0F, sprite.y);
        hn::Store(hn::Mul(hn::Set(d, profile.scale), hn::Sub(hn::Set(d, 1.0F), hn::Mul(hn::Set(d, profile.yy), hn::Mul(dy, dy)))), d, rest + i);
        if constexpr (kLean) {
            hn::Store(hn::Mul(hn::Set(d, profile.lean), dy), d, slope + i);
        }
    }
    const auto rowOf = [&](int row) HWY_ATTR {
        if constexpr (kLean) {
            return Rows{hn::Set(d, rest[row]), hn::Set(d, slope[row])};
        } else {
            return Rows{hn::Set(d, rest[row]), hn::Zero(d)};
        }
    };
    paintColumns<kLean, kFlat>(d, sprite, box, profile, rowOf, tile);
}

void paintPlainSprite(const SpriteStyle& style, const Sprite& sprite, Tile& tile)
{
    const bool lean = sprite.m00 * sprite.m01 + sprite.m10 * sprite.m11 != 0.0F;
    const bool flat = style.hardness > 1.0F;
    const auto paint = lean ? (flat ? paintPlain<true, true> : paintPlain<true, false>) : (flat ? paintPlain<false, true> : paintPlain<false, false>);
    paint(style, sprite, tile);
}

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

void clearTile(Tile& tile)
{
    std::fill_n(tile.planes.begin(), Tile::kPixels, 1.0F);
    std::fill(tile.planes.begin() + Tile::kPixels, tile.planes.end(), 0.0F);
}

bool isOpaque(const Tile& tile)
{
    const D d;
    constexpr float kInvisible = 1.0F / 1024.0F;
    const V limit = hn::Set(d, kInvisible);
    for (int y = tile.top; y < tile.bottom; ++y) {
        const float* row = tile.planes.data() + tileOffset(tile, tile.left, y);
        for (std::size_t i = 0; i < static_cast<std::size_t>(Compositor::kTileWidth); i += hn::Lanes(d)) {
            if (!hn::AllTrue(d, hn::Lt(hn::LoadU(d, row + i), limit))) {
                return false;
            }
        }
    }
    return true;
}

void writeTile(const Tile& tile, Image& image)
{
    for (int y = tile.top; y < tile.bottom; ++y) {
        float* HWY_RESTRICT to = image.row(y) + static_cast<std::size_t>(tile.left) * 4;
        const float* HWY_RESTRICT from = tile.planes.data() + tileOffset(tile, tile.left, y);
        const auto width = static_cast<std::size_t>(tile.right - tile.left);
        for (std::size_t i = 0; i < width; ++i) {
            to[i * 4] = from[i + Tile::kPixels];
            to[i * 4 + 1] = from[i + 2 * Tile::kPixels];
            to[i * 4 + 2] = from[i + 3 * Tile::kPixels];
            to[i * 4 + 3] = 1.0F - from[i];
        }
    }
}

void paint(const SpriteBatch& batch, const SpriteTexture& texture, std::span<const DepthEntry> entries, Tile& tile, Image& image)
{
    // Columns beyond the image's edge count as covered, or the last tile would never be full.
    clearTile(tile);
    for (int y = tile.top; y < tile.bottom && tile.right - tile.left < Compositor::kTileWidth; ++y) {
        for (int x = tile.right; x < tile.left + Compositor::kTileWidth; ++x) {
            tile.planes[tileOffset(tile, x, y)] = 0.0F;
        }
    }
    const bool shaded = batch.style.relief != 0.0F || batch.style.roundness != 0.0F;
    const auto paintSprite = batch.style.square ? (shaded ? paintTextured<true, true> : paintTextured<true, false>) : (shaded ? paintTextured<false, true> : paintTextured<false, false>);
    constexpr std::size_t kBetweenLooks = 32;
    constexpr std::size_t kAhead = 12;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (i % kBetweenLooks == 0 && i > 0 && isOpaque(tile)) {
            break;
        }
        if (i + kAhead < entries.size()) {
            hwy::Prefetch(&batch.sprites[entryIndex(entries[i + kAhead])]);
        }
        const Sprite& sprite = batch.sprites[entryIndex(entries[i])];
        if (unpackTexture(sprite.texture).level == TextureRef::kPlain) {
            paintPlainSprite(batch.style, sprite, tile);
        } else {
            paintSprite(batch.style, texture, sprite, tile);
        }
    }
    writeTile(tile, image);
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(paint);

void paintTile(const SpriteBatch& batch, const SpriteTexture& texture, std::span<const DepthEntry> entries, Tile& tile, Image& image)
{
    HWY_DYNAMIC_DISPATCH(paint)
    (batch, texture, entries, tile, image);
}

} // namespace fumage
#endif
