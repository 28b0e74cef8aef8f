// Included once per SIMD target: what the painters of sprites share, plain and textured.

#if defined(FUMAGE_TILE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_TILE_INL_H
#undef FUMAGE_TILE_INL_H
#else
#define FUMAGE_TILE_INL_H
#endif

#include "core/base/math-inl.h"
#include "core/rendering/passes.h"
#include "core/rendering/tile.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Pixels of a patch in one vector, or the part of them that fits: every vector of a patch starts at a multiple of its
/// lanes.
using D = hn::CappedTag<float, Tile::kPatchPixels>;
using V = hn::Vec<D>;
using I = hn::Vec<hn::RebindToSigned<D>>;

/// Patches of the tile inside the box of a sprite, inclusive.
struct Patches {
    int left, right, top, bottom;

    [[nodiscard]] bool none() const { return right < left || bottom < top; }
};

HWY_INLINE Patches patchesOf(const Sprite& sprite, const Tile& tile)
{
    // Pixel centres lie at halves. Bounded as floats, for which that takes no branch.
    const auto first = [](float edge, int least) {
        return static_cast<int>(std::max(static_cast<float>(least), std::ceil(edge - 0.5F))) - least;
    };
    const auto last = [](float edge, int least, int end) {
        return static_cast<int>(std::max(
                   std::min(static_cast<float>(end - 1), std::floor(edge - 0.5F)), static_cast<float>(least - 1)))
            - least;
    };
    const int left = first(sprite.x - sprite.halfWidth, tile.left);
    const int right = last(sprite.x + sprite.halfWidth, tile.left, tile.right);
    const int top = first(sprite.y - sprite.halfHeight, tile.top);
    const int bottom = last(sprite.y + sprite.halfHeight, tile.top, tile.bottom);
    // A row or column that ends before it begins may lie in one patch; shifted, what lies before the tile stays
    // negative.
    constexpr int kShift = 2;
    static_assert(1 << kShift == Tile::kPatch);
    return {left >> kShift, right < left ? -1 : right >> kShift, top >> kShift, bottom < top ? -1 : bottom >> kShift};
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

/// What a sprite shows at some pixels.
struct OwnColours {
    V red, green, blue;
};

/// Puts a sprite of some opacity and colour under what is there.
/// @return how much of it is seen
HWY_INLINE V under(D d, float* HWY_RESTRICT through, V a, const OwnColours& own)
{
    float* HWY_RESTRICT toRed = through + Tile::kPatchPixels;
    float* HWY_RESTRICT toGreen = through + 2 * Tile::kPatchPixels;
    float* HWY_RESTRICT toBlue = through + 3 * Tile::kPatchPixels;
    const V before = hn::Load(d, through);
    const V weight = a * before;
    hn::Store(weight * own.red + hn::Load(d, toRed), d, toRed);
    hn::Store(weight * own.green + hn::Load(d, toGreen), d, toGreen);
    hn::Store(weight * own.blue + hn::Load(d, toBlue), d, toBlue);
    hn::Store(before - weight, d, through);
    return weight;
}

HWY_INLINE std::size_t patchOffset(int column, int row)
{
    return static_cast<std::size_t>(row * Tile::kAcross + column) * Tile::kPatchFloats;
}

/// What lights the inside of a sprite in other targets: places in a list.
enum : std::size_t {
    kEvenly,
    kFromRight,
    kFromTop,
    kFromLeft,
    kFromBottom,
    kTargetLights,
};

/// Targets beside the sprites' own colours.
struct OtherTargets {
    struct One {
        const SpriteTarget* layers; ///< the colours of all sprites; null: the own of those of the first layers
        std::size_t red, green; ///< lights; nothing shades blue
        std::size_t firstLayers;
        bool isTinted; ///< by the picture of a sprite
    };
    std::array<One, kPassTargets> targets{};
    std::size_t count = 0;

    /// The colour of a sprite in one of them that has colours.
    [[nodiscard]] HWY_INLINE const float* colourOf(std::size_t target, SpriteNumber sprite) const
    {
        return targets[target].layers[sprite.layer()].colours.data() + sprite.slot() * SpriteTarget::kStride;
    }

    explicit OtherTargets(std::span<const RenderTarget> all)
    {
        for (const RenderTarget& target : all) {
            if (target.colours != nullptr) {
                targets[count++] = One{target.colours, lightOf(target, kFromRight, kFromLeft),
                    lightOf(target, kFromTop, kFromBottom), 0, target.colours->isTinted};
            } else if (!target.isWhole()) {
                targets[count++] = One{nullptr, kEvenly, kEvenly, target.firstLayers, false};
            }
        }
    }
    /// Floats from a patch of the tile to the next.
    [[nodiscard]] std::size_t stride() const { return count * Tile::kPatchFloats; }
    [[nodiscard]] std::size_t offset(int column, int row) const
    {
        return static_cast<std::size_t>(row * Tile::kAcross + column) * stride();
    }

private:
    static std::size_t lightOf(const RenderTarget& target, std::size_t above, std::size_t below)
    {
        switch (target.colours->light) {
        case TargetLight::Flat: break;
        case TargetLight::RightTopBack: return above;
        case TargetLight::LeftBottomFront: return below;
        }
        return kEvenly;
    }
};

/// A sprite in the other targets of a tile; of no account where there are none.
struct SpriteInTargets {
    const OtherTargets& targets;
    SpriteNumber sprite;

    /// Puts it under what is there.
    /// @param weight what under() has found @param own its colours, which under() took
    /// @param lights kTargetLights; null: all the same
    template <bool kLit>
    HWY_INLINE void under(D d, float* HWY_RESTRICT to, V weight, const OwnColours& own, const V* lights) const
    {
        for (std::size_t i = 0; i < targets.count; ++i, to += Tile::kPatchFloats) {
            const OtherTargets::One& target = targets.targets[i];
            const auto put = [&](std::size_t channel, V value) HWY_ATTR {
                float* HWY_RESTRICT at = to + (channel + 1) * Tile::kPatchPixels;
                hn::Store(weight * value + hn::Load(d, at), d, at);
            };
            if (target.layers == nullptr) {
                if (sprite.layer() < target.firstLayers) {
                    put(0, own.red);
                    put(1, own.green);
                    put(2, own.blue);
                    hn::Store(hn::Load(d, to) - weight, d, to);
                }
                continue;
            }
            const float* HWY_RESTRICT colour = targets.colourOf(i, sprite);
            const auto lit = [&](std::size_t channel, std::size_t light) HWY_ATTR {
                const V value = hn::Set(d, colour[channel]);
                if constexpr (kLit) {
                    return lights[light] * value;
                } else {
                    return value;
                }
            };
            put(0, lit(0, target.red));
            put(1, lit(1, target.green));
            put(2, hn::Set(d, colour[2]));
        }
    }

    /// The same of a sprite that looks like a picture: no light shades its inside.
    /// @param tint the picture's own colours
    HWY_INLINE void underTinted(
        D d, float* HWY_RESTRICT to, V weight, const OwnColours& own, const OwnColours& tint) const
    {
        for (std::size_t i = 0; i < targets.count; ++i, to += Tile::kPatchFloats) {
            const OtherTargets::One& target = targets.targets[i];
            const auto put = [&](const OwnColours& colours) HWY_ATTR {
                const auto add = [&](std::size_t channel, V value) HWY_ATTR {
                    float* HWY_RESTRICT at = to + (channel + 1) * Tile::kPatchPixels;
                    hn::Store(weight * value + hn::Load(d, at), d, at);
                };
                add(0, colours.red);
                add(1, colours.green);
                add(2, colours.blue);
            };
            if (target.layers == nullptr) {
                if (sprite.layer() < target.firstLayers) {
                    put(own);
                    hn::Store(hn::Load(d, to) - weight, d, to);
                }
                continue;
            }
            const float* HWY_RESTRICT colour = targets.colourOf(i, sprite);
            if (target.isTinted) {
                put({tint.red * colour[0], tint.green * colour[1], tint.blue * colour[2]});
            } else {
                put({hn::Set(d, colour[0]), hn::Set(d, colour[1]), hn::Set(d, colour[2])});
            }
        }
    }
};

/// Column and row of each pixel of a patch, at its centre.
alignas(kAlignment) constexpr float kColumns[Tile::kPatchPixels] = {
    0.5F, 1.5F, 2.5F, 3.5F, 0.5F, 1.5F, 2.5F, 3.5F, 0.5F, 1.5F, 2.5F, 3.5F, 0.5F, 1.5F, 2.5F, 3.5F};
alignas(kAlignment) constexpr float kRows[Tile::kPatchPixels] = {
    0.5F, 0.5F, 0.5F, 0.5F, 1.5F, 1.5F, 1.5F, 1.5F, 2.5F, 2.5F, 2.5F, 2.5F, 3.5F, 3.5F, 3.5F, 3.5F};

/// Way from the sprite's centre to pixels of a patch; exact before the subtraction, so that it does not depend on the
/// vector's width.
/// @param places kColumns or kRows, from the vector's part of the patch on @param start first pixel of the patch in the
/// image
HWY_INLINE V fromCentre(D d, const float* places, int start, float centre)
{
    return (hn::Load(d, places) + hn::Set(d, static_cast<float>(start))) - centre;
}

/// Room for one value of each pixel of a row or a column of patches, the same in all the others.
constexpr std::size_t kLineRoom = Tile::kPatchPixels * static_cast<std::size_t>(std::max(Tile::kAcross, Tile::kDown));

/// Columns of patches that the rim reaches in each row of patches.
struct Ends {
    alignas(kAlignment) std::int32_t first[roundUp(
        Tile::kDown, kAlignment / sizeof(std::int32_t))]; // NOLINT(cppcoreguidelines-avoid-c-arrays): not initialised
    alignas(kAlignment) std::int32_t
        last[roundUp(Tile::kDown, kAlignment / sizeof(std::int32_t))]; // NOLINT(cppcoreguidelines-avoid-c-arrays)

    HWY_INLINE Ends(const Sprite& sprite, const Rim& rim, const Patches& box, const Tile& tile)
    {
        const D d;
        const hn::RebindToSigned<D> di;
        const float slant = -rim.xy / rim.xx; // the centre of a row moves by this for each dy
        const V zero = hn::Zero(d);
        const V one = hn::Set(d, 1.0F);
        // from the first row of pixels in a patch to its last
        constexpr auto kReach = static_cast<float>(Tile::kPatch - 1);
        const V height = hn::Set(d, rim.yy + rim.xy * slant);
        const V halfRoot = hn::Set(d, 1.0F / std::sqrt(rim.xx));
        const V lean = hn::Set(d, 0.5F * kReach * std::abs(slant));
        const V toPatches = hn::Set(d, 1.0F / static_cast<float>(Tile::kPatch));
        const V nearEnd = hn::Set(d, static_cast<float>(box.left));
        const V farEnd = hn::Set(d, static_cast<float>(box.right));
        const V rows = hn::Iota(d, 0.0F) * hn::Set(d, static_cast<float>(Tile::kPatch));
        for (int i = 0; i <= box.bottom - box.top; i += static_cast<int>(hn::Lanes(d))) {
            const V dy =
                rows + hn::Set(d, static_cast<float>(tile.top + (box.top + i) * Tile::kPatch) + 0.5F - sprite.y);
            // The rows of a patch are as wide together as the widest, and the lean of the ellipse moves one against the
            // other.
            const V nearest = hn::IfThenElse(hn::Gt(dy, zero), dy, hn::Min(zero, dy + kReach));
            const V root = hn::Sqrt(hn::Max(zero, one - height * (nearest * nearest)));
            const V half = halfRoot * root + lean;
            // Counted in pixels, the centre of the tile's first being 0.
            const V middle = slant * (dy + 0.5F * kReach) + hn::Set(d, sprite.x - 0.5F - static_cast<float>(tile.left));
            hn::Store(
                hn::ConvertTo(di, hn::Max(nearEnd, hn::Floor(hn::Ceil(middle - half) * toPatches))), di, first + i);
            hn::Store(
                hn::ConvertTo(di, hn::Min(farEnd, hn::Floor(hn::Floor(middle + half) * toPatches))), di, last + i);
        }
    }
};

/// Calls paintRow(row, first, last) for each row of patches that a disc touches.
template <class PaintRow>
HWY_INLINE void forRows(
    const Sprite& sprite, const Rim& rim, const Patches& box, const Tile& tile, const PaintRow& paintRow)
{
    // A few patches are painted sooner than it is found which of them the rim leaves out.
    constexpr int kFew = 6;
    if (box.right - box.left < kFew) {
        for (int row = box.top; row <= box.bottom; ++row) {
            paintRow(row, box.left, box.right);
        }
        return;
    }
    const Ends ends(sprite, rim, box, tile);
    for (int row = box.top; row <= box.bottom; ++row) {
        paintRow(row, ends.first[row - box.top], ends.last[row - box.top]);
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
