// Included once per SIMD target: paints sprites that look like a picture, patch by patch.

#if defined(FUMAGE_PICTURED_SPRITE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_PICTURED_SPRITE_INL_H
#undef FUMAGE_PICTURED_SPRITE_INL_H
#else
#define FUMAGE_PICTURED_SPRITE_INL_H
#endif

#include "core/rendering/textured_sprite-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Premultiplied light of a picture at some pixels.
struct PictureAtPixels {
    V red, green, blue, alpha;
};

/// A level of a picture, and where a sprite reads it: at (p, q) in the sprite the texel is (p, q) reach + middle.
struct PictureReader {
    const float* texels;
    int edge;
    float reach, middle;

    PictureReader(const SpriteStyle& style, const SpritePicture& picture, const Sprite& sprite)
    {
        const int level = unpackTexture(sprite.texture).level;
        texels = picture.texels(level);
        edge = picture.levelSize(level);
        reach = style.pictureReach / static_cast<float>(1 << level);
        middle = reach - 0.5F; // half a texel from edge to centre
    }

    /// Bilinear; beyond its edges the picture goes on as it is there.
    [[nodiscard]] HWY_INLINE PictureAtPixels at(V p, V q) const
    {
        const D d;
        const hn::RebindToSigned<D> di;
        const V u = p * reach + middle;
        const V v = q * reach + middle;
        const V left = hn::Floor(u);
        const V top = hn::Floor(v);
        const V across = u - left;
        const V down = v - top;
        const I last = hn::Set(di, edge - 1);
        const auto inside = [&](I texel) HWY_ATTR { return hn::Min(hn::Max(texel, hn::Zero(di)), last); };
        const I one = hn::Set(di, 1);
        const I column = hn::ConvertTo(di, left);
        const I row = hn::ConvertTo(di, top);
        const I edges = hn::Set(di, edge);
        const I upper = hn::Mul(inside(row), edges);
        const I lower = hn::Mul(inside(hn::Add(row, one)), edges);
        const I nearer = inside(column);
        const I farther = inside(hn::Add(column, one));
        const auto indexOf = [&](I line, I place) HWY_ATTR { return hn::ShiftLeft<2>(hn::Add(line, place)); };
        const I places[] = {indexOf(upper, nearer), indexOf(upper, farther), indexOf(lower, nearer),
            indexOf(lower, farther)}; // NOLINT(cppcoreguidelines-avoid-c-arrays)
        const auto channel = [&](std::size_t which) HWY_ATTR {
            const auto texel = [&](I place) HWY_ATTR { return hn::GatherIndex(d, texels + which, place); };
            const V above = texel(places[0]);
            const V below = texel(places[2]);
            const V first = above + across * (texel(places[1]) - above);
            const V second = below + across * (texel(places[3]) - below);
            return first + down * (second - first);
        };
        return {channel(0), channel(1), channel(2), channel(3)};
    }
};

/// A square on which the picture is: its alpha times the opacity, its colours times the light.
/// @param kManyTargets there are other targets
template <bool kManyTargets>
void paintPictured(const SpriteStyle& style, const SpritePicture& picture, const Sprite& sprite,
    const SpriteInTargets& others, Tile& tile)
{
    const Patches box = patchesOf(sprite, tile);
    if (box.none()) {
        return;
    }
    const D d;
    const PictureReader reader(style, picture, sprite);
    const SquareRim edges(sprite);
    const V insideP = hn::Set(d, edges.p + kHalfEdge);
    const V insideQ = hn::Set(d, edges.q + kHalfEdge);
    const V red = hn::Set(d, sprite.direct[0] + sprite.ambient[0]);
    const V green = hn::Set(d, sprite.direct[1] + sprite.ambient[1]);
    const V blue = hn::Set(d, sprite.direct[2] + sprite.ambient[2]);

    /// @param at its pixels in the tile @param more those in the other targets
    const auto paintVector = [&](V dx, V dy, float* HWY_RESTRICT at, float* HWY_RESTRICT more) HWY_ATTR {
        const V p = sprite.m00 * dx + sprite.m01 * dy;
        const V q = sprite.m10 * dx + sprite.m11 * dy;
        const V mask = clamp01(d, insideP - hn::Abs(p * edges.p)) * clamp01(d, insideQ - hn::Abs(q * edges.q));
        const PictureAtPixels here = reader.at(p, q);
        constexpr float kNothing = 1e-6F; // of alpha
        const V straight = 1.0F / hn::Max(here.alpha, hn::Set(d, kNothing));
        const OwnColours tint{here.red * straight, here.green * straight, here.blue * straight};
        const OwnColours own{red * tint.red, green * tint.green, blue * tint.blue};
        const V weight = under(d, at, mask * here.alpha * sprite.opacity, own);
        if constexpr (kManyTargets) {
            others.underTinted(d, more, weight, own, tint);
        }
    };
    for (int row = box.top; row <= box.bottom; ++row) {
        for (std::size_t part = 0; part < Tile::kPatchPixels; part += hn::Lanes(d)) {
            const V dy = fromCentre(d, kRows + part, tile.top + row * Tile::kPatch, sprite.y);
            float* pixels = tile.patches.data() + patchOffset(box.left, row) + part;
            float* more = kManyTargets ? tile.others.data() + others.targets.offset(box.left, row) + part : nullptr;
            for (int column = box.left; column <= box.right;
                 ++column, pixels += Tile::kPatchFloats, more += others.targets.stride()) {
                paintVector(
                    fromCentre(d, kColumns + part, tile.left + column * Tile::kPatch, sprite.x), dy, pixels, more);
            }
        }
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
