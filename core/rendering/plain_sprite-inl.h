// Included once per SIMD target: paints sprites that are too small for their texture.

#if defined(FUMAGE_PLAIN_SPRITE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_PLAIN_SPRITE_INL_H
#undef FUMAGE_PLAIN_SPRITE_INL_H
#else
#define FUMAGE_PLAIN_SPRITE_INL_H
#endif

#include "core/rendering/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

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

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
