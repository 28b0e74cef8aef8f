// Included once per SIMD target: paints sprites with the noise that their air carries, patch by patch.

#if defined(FUMAGE_COHERENT_SPRITE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_COHERENT_SPRITE_INL_H
#undef FUMAGE_COHERENT_SPRITE_INL_H
#else
#define FUMAGE_COHERENT_SPRITE_INL_H
#endif

#include "core/lighting/phase_blend-inl.h"
#include "core/noise/detail_texture-inl.h"
#include "core/rendering/detail_alpha-inl.h"
#include "core/rendering/textured_sprite-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

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

/// Fixed-point texel coordinates of some pixels, by axis.
struct TexelsAt {
    I x, y, z;
};

/// What a row of pixels adds to the coordinates of its columns.
struct RowOfPhase {
    V x, y, z; ///< with kToFixed
};

/// One phase of a sprite with all that does not change from pixel to pixel.
template <std::size_t kLights>
struct PhaseReader {
    static_assert(kFractionBits == kTexelFractionBits);

    const SpriteDetail::Phase& phase;
    const std::int32_t* texels;
    int edge; ///< see edgeBits()
    float weight; ///< over the range of sums
    std::array<std::int32_t, kLights == 0 ? 1 : kLights> ways{}; ///< signed bytes, as LightBytes
    std::array<float, kLights == 0 ? 1 : kLights> added{}; ///< what is in the sums along a way beside the slopes
    std::array<float, kLights == 0 ? 1 : kLights> worth{};

    PhaseReader(const DetailTexture& texture, const SpriteDetail& detail, std::size_t which)
        : phase(detail.phases[which])
    {
        const int level = detail.levels[which];
        texels = reinterpret_cast<const std::int32_t*>(texture.texels(level));
        edge = edgeBits(level);
        constexpr float kOne = static_cast<float>(DetailTexture::kFull);
        weight = phase.weight / (kOne * kOne);
        const auto put = [&](std::size_t light, std::uint32_t bytes, float relief) {
            ways[light] = static_cast<std::int32_t>(bytes);
            int sum = 0;
            for (unsigned byte = 1; byte < sizeof(bytes); ++byte) {
                sum += static_cast<std::int8_t>(bytes >> 8U * byte & 255U);
            }
            constexpr float kToUnsigned = 128.0F;
            added[light] = kToUnsigned * static_cast<float>(sum);
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

    [[nodiscard]] HWY_INLINE RowOfPhase rowAt(V dy) const
    {
        const auto along = [&](std::size_t axis) HWY_ATTR { return phase.v[axis] * dy + (kToFixed + phase.at[axis]); };
        return {along(0), along(1), along(2)};
    }

    [[nodiscard]] HWY_INLINE TexelsAt texelsAt(const RowOfPhase& row, V dx) const
    {
        const hn::RebindToSigned<D> di;
        const auto along = [&](std::size_t axis, V down)
                               HWY_ATTR { return hn::BitCast(di, phase.u[axis] * dx + down); };
        return {along(0, row.x), along(1, row.y), along(2, row.z)};
    }

    [[nodiscard]] HWY_INLINE PhaseAtPixels<kLights> at(const TexelsAt& place) const
    {
        const D d;
        const hn::RebindToSigned<D> di;
        const auto [x, y, z] = place;
        const I texel = hn::GatherIndex(di, texels, texelIndex(edge, x, y, z));
        const I fractions = hn::Or(hn::Or(hn::Set(di, kFull), hn::And(hn::ShiftLeft<8>(x), hn::Set(di, kFull << 8))),
            hn::Or(hn::And(hn::ShiftLeft<16>(y), hn::Set(di, kFull << 16)),
                hn::And(hn::ShiftLeft<24>(z), hn::Set(di, kFull << 24))));
        const I ones = hn::Set(di, 0x00010001);
        const auto sum = [&](I pairs) HWY_ATTR { return hn::ConvertTo(d, dotHalves(di, pairs, ones)); };
        PhaseAtPixels<kLights> out;
        out.noise = sum(dotBytes(di, fractions, texel)) * weight;
        if constexpr (kLights > 0) {
            // Bytes that are multiplied with signed ones are not below 0: texels with 128 added.
            const I lifted = hn::Xor(texel, hn::Set(di, static_cast<std::int32_t>(0x80808080U)));
            for (std::size_t light = 0; light < kLights; ++light) {
                const V along = sum(dotBytes(di, lifted, hn::Set(di, ways[light])));
                out.slopes[light] = (along - added[light]) * worth[light];
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
    const Rim rim(sprite);
    constexpr std::size_t kLights = kManyTargets ? std::size_t{kSlopes} : kSunAlone;
    const std::size_t first = detail.shown[0] != 0 ? 0 : 1;
    const PhaseReader<kLights> one(texture, detail, first);
    const PhaseReader<kLights> two = kPhases == 2 ? PhaseReader<kLights>(texture, detail, 1) : one;
    const V zero = hn::Zero(d);
    const V bend = hn::Set(d, rim.xx * style.hardness);
    const V hardness = hn::Set(d, style.hardness);
    const V opacity = hn::Set(d, sprite.opacity * detail.perMean);
    const V maxAlpha = hn::Set(d, kMaxAlpha);
    const V directRed = hn::Set(d, sprite.direct[0]);
    const V directGreen = hn::Set(d, sprite.direct[1]);
    const V directBlue = hn::Set(d, sprite.direct[2]);
    const V ambientRed = hn::Set(d, sprite.ambient[0]);
    const V ambientGreen = hn::Set(d, sprite.ambient[1]);
    const V ambientBlue = hn::Set(d, sprite.ambient[2]);

    /// @param dx from the centre @param at its pixels in the tile @param more those in the other targets
    const auto paintVector = [&](const RowOfPhase& firstRow, const RowOfPhase& secondRow, V dx, V rest, V lean,
                                 float* HWY_RESTRICT at, float* HWY_RESTRICT more) HWY_ATTR {
        PhaseAtPixels<kLights> here = one.at(one.texelsAt(firstRow, dx));
        V even = here.noise * detail.gain;
        V grows = hn::Set(d, detail.gain);
        if constexpr (kPhases == 2) {
            const PhaseAtPixels<kLights> other = two.at(two.texelsAt(secondRow, dx));
            here.noise = here.noise + other.noise;
            for (std::size_t light = 0; light < kLights; ++light) {
                here.slopes[light] = here.slopes[light] + other.slopes[light];
            }
            const EvenNoise<V> sum = evened(detail, here.noise);
            even = sum.value;
            grows = sum.grows;
        }
        const V inside = clamp01(d, rest - dx * (bend * dx + lean));
        const V a = hn::Min(inside * inside * opacity * alphaFactor(d, even, detail.strength), maxAlpha);
        const auto shadeBy = [&](V slope) HWY_ATTR { return hn::Max(zero, grows * slope + 1.0F); };
        const V shade = shadeBy(here.slopes[kBySun]);
        const V around = hn::Max(zero, even * detail.around + 1.0F);
        const OwnColours own{shade * directRed + around * ambientRed, shade * directGreen + around * ambientGreen,
            shade * directBlue + around * ambientBlue};
        const V weight = under(d, at, a, own);
        if constexpr (kManyTargets) {
            const V right = here.slopes[kByRight];
            const V top = here.slopes[kByTop];
            const V shades[kTargetLights] = {hn::Set(d, 1.0F), shadeBy(right), shadeBy(top), shadeBy(hn::Neg(right)),
                shadeBy(hn::Neg(top))}; // NOLINT(cppcoreguidelines-avoid-c-arrays)
            others.under<true>(d, more, weight, own, shades);
        }
    };
    forRows(sprite, rim, box, tile, [&](int row, int from, int to) HWY_ATTR {
        for (std::size_t part = 0; part < Tile::kPatchPixels; part += hn::Lanes(d)) {
            const V dy = fromCentre(d, kRows + part, tile.top + row * Tile::kPatch, sprite.y);
            const V rest = hardness * (1.0F - rim.yy * dy * dy);
            const V lean = 2.0F * rim.xy * style.hardness * dy;
            const RowOfPhase firstRow = one.rowAt(dy);
            const RowOfPhase secondRow = kPhases == 2 ? two.rowAt(dy) : firstRow;
            float* pixels = tile.patches.data() + patchOffset(from, row) + part;
            float* more = kManyTargets ? tile.others.data() + others.targets.offset(from, row) + part : nullptr;
            for (int column = from; column <= to;
                 ++column, pixels += Tile::kPatchFloats, more += others.targets.stride()) {
                const V dx = fromCentre(d, kColumns + part, tile.left + column * Tile::kPatch, sprite.x);
                paintVector(firstRow, secondRow, dx, rest, lean, pixels, more);
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
