#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/rendering/tile_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "core/base/math-inl.h"
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

/// The ellipse p^2 + q^2 = 1 as a xx dx^2 + 2 xy dx dy + yy dy^2 = 1, solved row by row.
struct Ellipse {
    float xx, xy, yy;
    float slant;  ///< centre of a row moves by this for each dy
    float height; ///< yy without the slant

    explicit Ellipse(const Sprite& s)
        : xx(s.m00 * s.m00 + s.m10 * s.m10)
        , xy(s.m00 * s.m01 + s.m10 * s.m11)
        , yy(s.m01 * s.m01 + s.m11 * s.m11)
        , slant(-xy / xx)
        , height(yy - xy * xy / xx)
    {
    }

    /// Narrows a box to the row dy; false where the row is empty.
    [[nodiscard]] bool row(const Sprite& sprite, const Box& box, float dy, int& first, int& last) const
    {
        const float rest = 1.0F - height * dy * dy;
        if (rest <= 0.0F) {
            return false;
        }
        const float half = std::sqrt(rest / xx);
        const float middle = sprite.x + slant * dy;
        first = std::max(box.left, static_cast<int>(std::ceil(middle - half - 0.5F)));
        last = std::min(box.right, static_cast<int>(std::floor(middle + half - 0.5F)));
        return first <= last;
    }
};

/// Adds a layer of opacity a and colour c under what is there.
HWY_INLINE void under(Tile& tile, std::size_t at, V a, V red, V green, V blue)
{
    const D d;
    const V through = hn::LoadU(d, tile.through.data() + at);
    const V weight = hn::Mul(a, through);
    hn::StoreU(mulAdd(weight, red, hn::LoadU(d, tile.red.data() + at)), d, tile.red.data() + at);
    hn::StoreU(mulAdd(weight, green, hn::LoadU(d, tile.green.data() + at)), d, tile.green.data() + at);
    hn::StoreU(mulAdd(weight, blue, hn::LoadU(d, tile.blue.data() + at)), d, tile.blue.data() + at);
    hn::StoreU(hn::Sub(through, weight), d, tile.through.data() + at);
}

/// Profile of a soft disc from 1 - r^2: clamp(hardness (1 - r^2), 0, 1)^2.
HWY_INLINE V discMask(D d, V inside, V hardness)
{
    const V t = clamp01(d, hn::Mul(inside, hardness));
    return hn::Mul(t, t);
}

/// x coordinates of a vector of pixels relative to the sprite; exact before the subtraction, so that they do not depend on the vector's width.
HWY_INLINE V offsets(D d, int first, float centre)
{
    return hn::Sub(hn::Add(hn::Iota(d, static_cast<float>(first)), hn::Set(d, 0.5F)), hn::Set(d, centre));
}

HWY_INLINE std::size_t tileOffset(const Tile& tile, int x, int y)
{
    return static_cast<std::size_t>(y - tile.top) * Tile::kStride + static_cast<std::size_t>(x - tile.left);
}

/// A sprite too small for its texture: a soft disc of one colour.
void paintPlain(const SpriteStyle& style, const Sprite& sprite, Tile& tile)
{
    const D d;
    const Box box = boxOf(sprite, tile);
    const Ellipse ellipse(sprite);
    const V red = hn::Set(d, sprite.direct[0] + sprite.ambient[0]);
    const V green = hn::Set(d, sprite.direct[1] + sprite.ambient[1]);
    const V blue = hn::Set(d, sprite.direct[2] + sprite.ambient[2]);
    const V opacity = hn::Set(d, sprite.opacity);
    const V hardness = hn::Set(d, style.hardness);
    const V xx = hn::Set(d, ellipse.xx);
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (int y = box.top; y <= box.bottom; ++y) {
        const float dy = (static_cast<float>(y) + 0.5F) - sprite.y;
        const V slope = hn::Set(d, 2.0F * ellipse.xy * dy);
        const V rest = hn::Set(d, 1.0F - ellipse.yy * dy * dy);
        for (int x = box.left; x <= box.right; x += lanes) {
            const V dx = offsets(d, x, sprite.x);
            const V inside = hn::Sub(rest, hn::Mul(dx, mulAdd(xx, dx, slope)));
            under(tile, tileOffset(tile, x, y), hn::Mul(opacity, discMask(d, inside, hardness)), red, green, blue);
        }
    }
}

/// What a textured sprite needs for each of its pixels.
struct TexturedSprite {
    const std::uint32_t* texels;
    int shift; ///< log2 of the level's edge
    float texelsAcross, u, v;
    float erosion, erosionScale; ///< of grey values 0..255
    float plainOpacity, noiseOpacity;
    float reliefU, reliefV; ///< shading by the noise's slope, per grey value
    float roundP, roundQ;

    TexturedSprite(const SpriteStyle& style, const SpriteTexture& texture, const Sprite& sprite)
    {
        const TextureRef ref = unpackTexture(sprite.texture);
        texels = texture.texels(ref.level, ref.slice);
        const int edge = texture.levelSize(ref.level);
        shift = std::countr_zero(static_cast<unsigned>(edge));
        texelsAcross = 0.5F * style.textureScale * static_cast<float>(edge);
        u = static_cast<float>(ref.u) * (1.0F / 256.0F) * static_cast<float>(edge) - 0.5F;
        v = static_cast<float>(ref.v) * (1.0F / 256.0F) * static_cast<float>(edge) - 0.5F;
        erosion = ref.erosion * 255.0F;
        erosionScale = 1.0F / (255.0F * style.erosionSoftness);
        noiseOpacity = sprite.opacity * style.texture;
        plainOpacity = sprite.opacity - noiseOpacity;
        // The way of the light in the sprite: turned by its matrix without the scale.
        const float scale = 1.0F / std::sqrt(std::abs(sprite.m00 * sprite.m11 - sprite.m01 * sprite.m10));
        const float lightP = (sprite.m00 * style.lightX + sprite.m01 * style.lightY) * scale;
        const float lightQ = (sprite.m10 * style.lightX + sprite.m11 * style.lightY) * scale;
        // A slope per texel times the texels across is one per radius, whatever the resolution.
        const float slope = style.relief * texelsAcross / 255.0F;
        reliefU = lightP * slope;
        reliefV = lightQ * slope;
        roundP = -lightP * style.roundness;
        roundQ = -lightQ * style.roundness;
    }
};

template <bool kSquare>
void paintTextured(const SpriteStyle& style, const SpriteTexture& texture, const Sprite& sprite, Tile& tile)
{
    const D d;
    const hn::RebindToSigned<D> di;
    const TexturedSprite look(style, texture, sprite);
    const Box box = boxOf(sprite, tile);
    const Ellipse ellipse(sprite);
    const V one = hn::Set(d, 1.0F);
    const auto wrap = hn::Set(di, (1 << look.shift) - 1);
    const auto low = hn::Set(di, 255);
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (int y = box.top; y <= box.bottom; ++y) {
        const float dy = (static_cast<float>(y) + 0.5F) - sprite.y;
        int first = box.left;
        int last = box.right;
        if (!kSquare && !ellipse.row(sprite, box, dy, first, last)) {
            continue;
        }
        const V pRow = hn::Set(d, sprite.m01 * dy);
        const V qRow = hn::Set(d, sprite.m11 * dy);
        for (int x = first; x <= last; x += lanes) {
            const V dx = offsets(d, x, sprite.x);
            const V p = mulAdd(hn::Set(d, sprite.m00), dx, pRow);
            const V q = mulAdd(hn::Set(d, sprite.m10), dx, qRow);
            V mask;
            if constexpr (kSquare) {
                mask = hn::IfThenElseZero(hn::Lt(hn::Max(hn::Abs(p), hn::Abs(q)), one), one);
            } else {
                mask = discMask(d, hn::Sub(one, mulAdd(p, p, hn::Mul(q, q))), hn::Set(d, style.hardness));
            }

            const V u = mulAdd(p, hn::Set(d, look.texelsAcross), hn::Set(d, look.u));
            const V v = mulAdd(q, hn::Set(d, look.texelsAcross), hn::Set(d, look.v));
            const V wholeU = hn::Floor(u);
            const V wholeV = hn::Floor(v);
            const V fu = hn::Sub(u, wholeU);
            const V fv = hn::Sub(v, wholeV);
            const auto iu = hn::And(hn::ConvertTo(di, wholeU), wrap);
            const auto iv = hn::And(hn::ConvertTo(di, wholeV), wrap);
            const auto index = hn::Add(hn::ShiftLeftSame(iv, look.shift), iu);
            const auto texel = hn::GatherIndex(di, reinterpret_cast<const std::int32_t*>(look.texels), index);
            const V g00 = hn::ConvertTo(d, hn::And(texel, low));
            const V g10 = hn::ConvertTo(d, hn::And(hn::ShiftRight<8>(texel), low));
            const V g01 = hn::ConvertTo(d, hn::And(hn::ShiftRight<16>(texel), low));
            const V g11 = hn::ConvertTo(d, hn::And(hn::ShiftRight<24>(texel), low));
            const V slope0 = hn::Sub(g10, g00);
            const V slope1 = hn::Sub(g11, g01);
            const V row0 = mulAdd(fu, slope0, g00);
            const V slopeV = hn::Sub(mulAdd(fu, slope1, g01), row0);
            const V slopeU = mulAdd(fv, hn::Sub(slope1, slope0), slope0);
            const V grey = mulAdd(fv, slopeV, row0);

            const V kept = clamp01(d, hn::Mul(hn::Sub(grey, hn::Set(d, look.erosion)), hn::Set(d, look.erosionScale)));
            const V a = hn::Mul(mask, mulAdd(hn::Set(d, look.noiseOpacity), kept, hn::Set(d, look.plainOpacity)));
            V shade = mulAdd(hn::Set(d, look.reliefU), slopeU, one);
            shade = mulAdd(hn::Set(d, look.reliefV), slopeV, shade);
            shade = mulAdd(hn::Set(d, look.roundP), p, shade);
            shade = mulAdd(hn::Set(d, look.roundQ), q, shade);
            shade = hn::Max(shade, hn::Zero(d));
            under(tile, tileOffset(tile, x, y), a, mulAdd(shade, hn::Set(d, sprite.direct[0]), hn::Set(d, sprite.ambient[0])),
                mulAdd(shade, hn::Set(d, sprite.direct[1]), hn::Set(d, sprite.ambient[1])), mulAdd(shade, hn::Set(d, sprite.direct[2]), hn::Set(d, sprite.ambient[2])));
        }
    }
}

void clearTile(Tile& tile)
{
    tile.through.fill(1.0F);
    tile.red.fill(0.0F);
    tile.green.fill(0.0F);
    tile.blue.fill(0.0F);
}

bool isOpaque(const Tile& tile)
{
    const D d;
    constexpr float kInvisible = 1.0F / 1024.0F;
    const V limit = hn::Set(d, kInvisible);
    for (int y = tile.top; y < tile.bottom; ++y) {
        const float* row = tile.through.data() + tileOffset(tile, tile.left, y);
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
        const std::size_t at = tileOffset(tile, tile.left, y);
        const auto width = static_cast<std::size_t>(tile.right - tile.left);
        for (std::size_t i = 0; i < width; ++i) {
            to[i * 4] = tile.red[at + i];
            to[i * 4 + 1] = tile.green[at + i];
            to[i * 4 + 2] = tile.blue[at + i];
            to[i * 4 + 3] = 1.0F - tile.through[at + i];
        }
    }
}

void paint(const SpriteBatch& batch, const SpriteTexture& texture, std::span<const DepthEntry> entries, Tile& tile, Image& image)
{
    // Columns beyond the image's edge count as covered, or the last tile would never be full.
    clearTile(tile);
    for (int y = tile.top; y < tile.bottom && tile.right - tile.left < Compositor::kTileWidth; ++y) {
        for (int x = tile.right; x < tile.left + Compositor::kTileWidth; ++x) {
            tile.through[tileOffset(tile, x, y)] = 0.0F;
        }
    }
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
            paintPlain(batch.style, sprite, tile);
        } else if (batch.style.square) {
            paintTextured<true>(batch.style, texture, sprite, tile);
        } else {
            paintTextured<false>(batch.style, texture, sprite, tile);
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
    HWY_DYNAMIC_DISPATCH(paint)(batch, texture, entries, tile, image);
}

} // namespace fumage
#endif
