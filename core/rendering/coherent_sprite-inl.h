// Included once per SIMD target: paints sprites with the noise that their air carries, patch by patch.

#if defined(FUMAGE_COHERENT_SPRITE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_COHERENT_SPRITE_INL_H
#undef FUMAGE_COHERENT_SPRITE_INL_H
#else
#define FUMAGE_COHERENT_SPRITE_INL_H
#endif

#include "core/rendering/textured_sprite-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Texel coordinates of one phase for each column and each row of a sprite's pixels in a tile: the sum of both is that
/// of a pixel.
struct PhaseLines {
    // Not initialised: that would cost more than the painting.
    // NOLINTBEGIN(cppcoreguidelines-avoid-c-arrays)
    alignas(kAlignment) float across[3][kLineRoom];
    alignas(kAlignment) float down[3][kLineRoom]; ///< with kToFixed
    // NOLINTEND(cppcoreguidelines-avoid-c-arrays)

    HWY_INLINE void fill(const SpriteDetail::Phase& phase, const Sprite& sprite, const Patches& box, const Tile& tile)
    {
        const D d;
        for (std::size_t part = 0; part < Tile::kPatchPixels; part += hn::Lanes(d)) {
            for (int column = box.left; column <= box.right; ++column) {
                const std::size_t at = static_cast<std::size_t>(column) * Tile::kPatchPixels + part;
                const V dx = fromCentre(d, kColumns + part, tile.left + column * Tile::kPatch, sprite.x);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    hn::Store(phase.u[axis] * dx, d, across[axis] + at);
                }
            }
            for (int row = box.top; row <= box.bottom; ++row) {
                const std::size_t at = static_cast<std::size_t>(row) * Tile::kPatchPixels + part;
                const V dy = fromCentre(d, kRows + part, tile.top + row * Tile::kPatch, sprite.y);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    hn::Store(phase.v[axis] * dy + (kToFixed + phase.at[axis]), d, down[axis] + at);
                }
            }
        }
    }
};

/// What one phase shows at some pixels: the noise, and what it changes by along the ways of lights.
template <std::size_t kLights>
struct PhaseAtPixels {
    V noise;
    V slopes[kLights == 0 ? 1 : kLights]; // NOLINT(cppcoreguidelines-avoid-c-arrays)
};

/// Lights by whose ways the slope of the noise is asked for: none, the sun, or that and those from the right and the
/// top of the picture, of which those from the left and the bottom are the opposite.
enum : std::size_t {
    kBySun,
    kByRight,
    kByTop,
    kSlopes,
};

/// One phase of a sprite with all that does not change from pixel to pixel.
template <std::size_t kLights>
struct PhaseReader {
    const std::int32_t* texels;
    int shift; ///< log2 of the level's edge
    float weight; ///< over the range of sums
    std::array<std::int32_t, kLights == 0 ? 1 : kLights> ways{};
    std::array<float, kLights == 0 ? 1 : kLights> worth{};

    PhaseReader(const DetailTexture& texture, const SpriteDetail& detail, std::size_t which)
    {
        const SpriteDetail::Phase& phase = detail.phases[which];
        const int level = detail.levels[which];
        texels = reinterpret_cast<const std::int32_t*>(texture.texels(level));
        shift = std::countr_zero(static_cast<unsigned>(DetailTexture::size(level)));
        constexpr float kOne = static_cast<float>(DetailTexture::kFull);
        weight = phase.weight / (kOne * kOne);
        const auto put = [&](std::size_t light, std::uint32_t bytes, float relief) {
            ways[light] = static_cast<std::int32_t>(bytes);
            worth[light] = relief / kOne;
        };
        if constexpr (kLights > kBySun) {
            put(kBySun, phase.light, phase.relief);
        }
        if constexpr (kLights > kByTop) {
            // From the right and looked at towards it, the noise falls where it rises to the left.
            const float relief = phase.weight * detail.screenRelief;
            const LightBytes right(-phase.u[0], -phase.u[1], -phase.u[2]);
            const LightBytes top(phase.v[0], phase.v[1], phase.v[2]);
            put(kByRight, right.packed, relief * right.scale);
            put(kByTop, top.packed, relief * top.scale);
        }
    }

    /// @param x,y,z as fixed-point numbers
    HWY_INLINE PhaseAtPixels<kLights> at(I x, I y, I z) const
    {
        const D d;
        const hn::RebindToSigned<D> di;
        const I wrap = hn::Set(di, (1 << shift) - 1);
        const auto texel = [&](I along) HWY_ATTR { return hn::And(hn::ShiftRight<kFractionBits>(along), wrap); };
        const I row = hn::Or(hn::ShiftLeftSame(texel(z), shift), texel(y));
        const I index = hn::Or(hn::ShiftLeftSame(row, shift), texel(x));
        const I numbers = hn::GatherIndex(di, texels, index);
        const I fraction = hn::Set(di, kFull);
        const I fractions = hn::Or(hn::Or(fraction, hn::ShiftLeft<8>(hn::And(x, fraction))),
            hn::Or(hn::ShiftLeft<16>(hn::And(y, fraction)), hn::ShiftLeft<24>(hn::And(z, fraction))));
        const I ones = hn::Set(di, 0x00010001);
        const auto sum = [&](I pairs) HWY_ATTR { return hn::ConvertTo(d, dotHalves(di, pairs, ones)); };
        PhaseAtPixels<kLights> out;
        out.noise = sum(dotBytes(di, fractions, numbers)) * weight;
        if constexpr (kLights > 0) {
            // Bytes of ways are not below 0: what was added to them goes again.
            const V added = sum(dotBytes(di, hn::Set(di, LightBytes::kLongest * 0x01010100), numbers));
            for (std::size_t light = 0; light < kLights; ++light) {
                const V along = sum(dotBytes(di, hn::Set(di, ways[light]), numbers));
                out.slopes[light] = (along - added) * worth[light];
            }
        }
        return out;
    }
};

/// @param kPhases 1 or 2 @param kManyTargets there are other targets
template <int kPhases, bool kManyTargets>
void paintCoherent(const SpriteStyle& style, const DetailTexture& texture, const Sprite& sprite,
    const SpriteDetail& detail, const SpriteInTargets& others, Tile& tile)
{
    const Patches box = patchesOf(sprite, tile);
    if (box.none()) {
        return;
    }
    const D d;
    const hn::RebindToSigned<D> di;
    const Rim rim(sprite);
    constexpr std::size_t kLights = kManyTargets ? std::size_t{kSlopes} : kSunAlone;
    const std::size_t first = detail.shown[0] != 0 ? 0 : 1;
    const PhaseReader<kLights> one(texture, detail, first);
    const PhaseReader<kLights> two(texture, detail, 1);
    PhaseLines lines[kPhases]; // NOLINT(cppcoreguidelines-avoid-c-arrays): not initialised
    lines[0].fill(detail.phases[first], sprite, box, tile);
    if constexpr (kPhases == 2) {
        lines[1].fill(detail.phases[1], sprite, box, tile);
    }
    const V zero = hn::Zero(d);
    const V bend = hn::Set(d, rim.xx * style.hardness);
    const V hardness = hn::Set(d, style.hardness);
    const V opacity = hn::Set(d, sprite.opacity * detail.perMean);
    constexpr float kMaxAlpha = 0.995F;
    const V maxAlpha = hn::Set(d, kMaxAlpha);
    const V directRed = hn::Set(d, sprite.direct[0]);
    const V directGreen = hn::Set(d, sprite.direct[1]);
    const V directBlue = hn::Set(d, sprite.direct[2]);
    const V ambientRed = hn::Set(d, sprite.ambient[0]);
    const V ambientGreen = hn::Set(d, sprite.ambient[1]);
    const V ambientBlue = hn::Set(d, sprite.ambient[2]);

    /// @param dx,dy from the centre @param at its pixels in the tile @param more those in the other targets
    const auto paintVector = [&](std::size_t across, std::size_t down, V dx, V rest, V lean, float* HWY_RESTRICT at,
                                 float* HWY_RESTRICT more) HWY_ATTR {
        const auto read = [&](const PhaseReader<kLights>& phase, const PhaseLines& line) HWY_ATTR {
            const auto fixed = [&](std::size_t axis) HWY_ATTR {
                return hn::BitCast(di, hn::Load(d, line.across[axis] + across) + hn::Load(d, line.down[axis] + down));
            };
            return phase.at(fixed(0), fixed(1), fixed(2));
        };
        PhaseAtPixels<kLights> here = read(one, lines[0]);
        if constexpr (kPhases == 2) {
            const PhaseAtPixels<kLights> other = read(two, lines[1]);
            here.noise = here.noise + other.noise;
            for (std::size_t light = 0; light < kLights; ++light) {
                here.slopes[light] = here.slopes[light] + other.slopes[light];
            }
        }
        const V size = hn::Abs(here.noise);
        const V beyond = hn::Max(zero, size - detail.flat);
        const V even = hn::CopySign(size * detail.gain - beyond * beyond * detail.bend, here.noise);
        const V grows = detail.gain - beyond * (2.0F * detail.bend);
        // 0 below 1 + s t = -1/2, a parabola up to 1/2, straight above.
        const V bent = even * detail.strength + 1.5F;
        const V low = clamp01(d, bent);
        const V factor = low * low * 0.5F + hn::Max(zero, bent - 1.0F);
        const V inside = clamp01(d, rest - dx * (bend * dx + lean));
        const V a = hn::Min(inside * inside * opacity * factor, maxAlpha);
        const auto shadeBy = [&](V slope) HWY_ATTR { return hn::Max(zero, grows * slope + 1.0F); };
        const V shade = shadeBy(here.slopes[kBySun]);
        const V around = hn::Max(zero, even * detail.around + 1.0F);
        const V weight = under(d, at, a, shade * directRed + around * ambientRed,
            shade * directGreen + around * ambientGreen, shade * directBlue + around * ambientBlue);
        if constexpr (kManyTargets) {
            const V right = here.slopes[kByRight];
            const V top = here.slopes[kByTop];
            const V shades[kTargetLights] = {hn::Set(d, 1.0F), shadeBy(right), shadeBy(top), shadeBy(hn::Neg(right)),
                shadeBy(hn::Neg(top))}; // NOLINT(cppcoreguidelines-avoid-c-arrays)
            others.under<true>(d, more, weight, shades);
        }
    };
    forRows(sprite, rim, box, tile, [&](int row, int from, int to) HWY_ATTR {
        for (std::size_t part = 0; part < Tile::kPatchPixels; part += hn::Lanes(d)) {
            const V dy = fromCentre(d, kRows + part, tile.top + row * Tile::kPatch, sprite.y);
            const V rest = hardness * (1.0F - rim.yy * dy * dy);
            const V lean = 2.0F * rim.xy * style.hardness * dy;
            float* pixels = tile.patches.data() + patchOffset(from, row) + part;
            float* more = kManyTargets ? tile.others.data() + others.targets.offset(from, row) + part : nullptr;
            const std::size_t down = static_cast<std::size_t>(row) * Tile::kPatchPixels + part;
            for (int column = from; column <= to;
                 ++column, pixels += Tile::kPatchFloats, more += others.targets.stride()) {
                const V dx = fromCentre(d, kColumns + part, tile.left + column * Tile::kPatch, sprite.x);
                paintVector(
                    static_cast<std::size_t>(column) * Tile::kPatchPixels + part, down, dx, rest, lean, pixels, more);
            }
        }
    });
}

/// Whether a sprite shows detail that its air carries; those that do not are painted as others.
HWY_INLINE bool isCoherent(const SpriteBatch& batch, std::size_t index)
{
    return !batch.details.empty() && (batch.details[index].shown[0] | batch.details[index].shown[1]) != 0;
}

template <bool kManyTargets>
void paintCoherentSprite(const SpriteBatch& batch, const DetailTexture& texture, std::size_t index,
    const SpriteInTargets& others, Tile& tile)
{
    const SpriteDetail& detail = batch.details[index];
    const bool both = (detail.shown[0] & detail.shown[1]) != 0;
    const auto paint = both ? paintCoherent<2, kManyTargets> : paintCoherent<1, kManyTargets>;
    paint(batch.style, texture, batch.sprites[index], detail, others, tile);
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
