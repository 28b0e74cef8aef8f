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

/// The profile of a sprite that is too small for its texture: alpha = (rest - bend dx^2 - slope dx)^2, where rest and
/// slope change with the row. All have the root of the opacity in them.
struct PlainProfile {
    float bend, lean, yy, scale, highest;

    PlainProfile(const SpriteStyle& style, const Sprite& sprite, const Rim& rim)
        : yy(rim.yy)
        , highest(std::sqrt(sprite.opacity))
    {
        scale = style.hardness * highest;
        bend = rim.xx * scale;
        lean = 2.0F * rim.xy * scale;
    }
};

/// A sprite too small for its texture: a soft disc of one colour.
/// @param kLean the rim is no circle @param kFlat the profile reaches its full height before the centre @param
/// kManyTargets there are other targets
template <bool kLean, bool kFlat, bool kManyTargets>
void paintPlain(const SpriteStyle& style, const Sprite& sprite, const SpriteInTargets& others, Tile& tile)
{
    const Patches box = patchesOf(sprite, tile);
    if (box.none()) {
        return;
    }
    const D d;
    const std::size_t lanes = hn::Lanes(d);
    const Rim rim(sprite);
    const PlainProfile profile(style, sprite, rim);
    const OwnColours own{hn::Set(d, sprite.direct[0] + sprite.ambient[0]),
        hn::Set(d, sprite.direct[1] + sprite.ambient[1]), hn::Set(d, sprite.direct[2] + sprite.ambient[2])};
    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0F);
    const V most = hn::Set(d, profile.highest);

    alignas(kAlignment) float across[kLineRoom]; // NOLINT(cppcoreguidelines-avoid-c-arrays): not initialised
    alignas(kAlignment) float curve[kLineRoom]; // NOLINT(cppcoreguidelines-avoid-c-arrays)
    for (int column = box.left; column <= box.right; ++column) {
        for (std::size_t part = 0; part < Tile::kPatchPixels; part += lanes) {
            const std::size_t at = static_cast<std::size_t>(column) * Tile::kPatchPixels + part;
            const V dx = fromCentre(d, kColumns + part, tile.left + column * Tile::kPatch, sprite.x);
            hn::Store(hn::Mul(hn::Set(d, profile.bend), hn::Mul(dx, dx)), d, curve + at);
            if constexpr (kLean) {
                hn::Store(dx, d, across + at);
            }
        }
    }
    forRows(sprite, rim, box, tile, [&](int row, int first, int last) HWY_ATTR {
        for (std::size_t part = 0; part < Tile::kPatchPixels; part += lanes) {
            const V dy = fromCentre(d, kRows + part, tile.top + row * Tile::kPatch, sprite.y);
            const V rest =
                hn::Mul(hn::Set(d, profile.scale), hn::Sub(one, hn::Mul(hn::Set(d, profile.yy), hn::Mul(dy, dy))));
            const V slope = hn::Mul(hn::Set(d, profile.lean), dy);
            float* pixels = tile.patches.data() + patchOffset(first, row) + part;
            float* more = kManyTargets ? tile.others.data() + others.targets.offset(first, row) + part : nullptr;
            for (int column = first; column <= last;
                 ++column, pixels += Tile::kPatchFloats, more += others.targets.stride()) {
                const std::size_t at = static_cast<std::size_t>(column) * Tile::kPatchPixels + part;
                V root = hn::Sub(rest, hn::Load(d, curve + at));
                if constexpr (kLean) {
                    root = hn::Sub(root, hn::Mul(slope, hn::Load(d, across + at)));
                }
                root = hn::Max(root, zero);
                if constexpr (kFlat) {
                    root = hn::Min(root, most);
                }
                const V weight = under(d, pixels, hn::Mul(root, root), own);
                if constexpr (kManyTargets) {
                    others.under<false>(d, more, weight, own, nullptr);
                }
            }
        }
    });
}

template <bool kManyTargets>
void paintPlainSprite(const SpriteStyle& style, const Sprite& sprite, const SpriteInTargets& others, Tile& tile)
{
    const bool lean = sprite.m00 * sprite.m01 + sprite.m10 * sprite.m11 != 0.0F;
    const bool flat = style.hardness > 1.0F;
    const auto paint = lean ? (flat ? paintPlain<true, true, kManyTargets> : paintPlain<true, false, kManyTargets>)
                            : (flat ? paintPlain<false, true, kManyTargets> : paintPlain<false, false, kManyTargets>);
    paint(style, sprite, others, tile);
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
