#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/rendering/sprite_detail.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/hash-inl.h"
#include "core/lighting/detail_lookup-inl.h"
#include "core/rendering/detail_alpha-inl.h"
#include "core/rendering/sprite_detail.h"

#include <algorithm>

#include <glm/geometric.hpp>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using U = hn::Vec<hn::RebindToUnsigned<D>>;
using I = hn::Vec<hn::RebindToSigned<D>>;

/// How far into the light the noise is looked at for relief, in waves.
constexpr float kReliefReach = 0.032F;
/// What a relief of 1 multiplies the difference by.
constexpr float kRelief = 2.0F;

/// The mean of alphaFactor() over even noise, s being the strength: a parabola is (y + 1/2)^2 / 2.
HWY_INLINE V meanOfFactor(V s)
{
    constexpr float kHalf = 0.5F;
    const D d;
    const V low = hn::Max(hn::Zero(d), (1.0F + kHalf) - s);
    const V high = s + 1.0F;
    const V below = (1.0F - low * low * low) * (1.0F / 6.0F);
    const V mean = hn::Div(below + (high * high - kHalf * kHalf) * 0.5F, s * 2.0F);
    return hn::IfThenElse(hn::Le(s, hn::Set(d, kHalf)), hn::Set(d, 1.0F), mean);
}

/// The vector form of LightBytes.
struct LightBytesOf {
    I packed;
    V scale;

    HWY_INLINE explicit LightBytesOf(const Vec3<V>& way)
    {
        const D d;
        const hn::RebindToSigned<D> di;
        constexpr auto kLongest = static_cast<float>(LightBytes::kLongest);
        constexpr float kNone = 1e-20F;
        const V longest = hn::Max(hn::Max(hn::Abs(way.x), hn::Abs(way.y)), hn::Abs(way.z));
        scale = longest * (1.0F / kLongest);
        const V perUnit = kLongest / hn::Max(longest, hn::Set(d, kNone));
        const auto byte = [&](V component) HWY_ATTR {
            const I counted = hn::ConvertTo(di, component * perUnit + (kLongest + 0.5F));
            return hn::And(counted - LightBytes::kLongest, hn::Set(di, 255));
        };
        packed = hn::Or(
            hn::Or(hn::ShiftLeft<8>(byte(way.x)), hn::ShiftLeft<16>(byte(way.y))), hn::ShiftLeft<24>(byte(way.z)));
    }
};

/// Particles in the picture, as their detail is found.
struct Places {
    Vec3<V> at; ///< m
    Vec3<V> jitter; ///< texels; see findPhase()
    V octaves; ///< random, 0 to 1: octaves that are likelier are shown
    V metresPerPixel;
    V finest; ///< m, that the sprites can show
    V relief; ///< what there is of it in smoke as deep as here
};

/// One number of each lane, on its way into the sprites.
using LaneFloats = std::array<float, hn::MaxLanes(D())>;
using LaneWords = std::array<std::int32_t, hn::MaxLanes(D())>;

/// SpriteDetail::Phase of each lane.
struct alignas(kAlignment) LanePhases {
    alignas(kAlignment) std::array<LaneFloats, 3> at;
    alignas(kAlignment) std::array<LaneFloats, 3> u;
    alignas(kAlignment) std::array<LaneFloats, 3> v;
    alignas(kAlignment) LaneWords light;
    alignas(kAlignment) LaneFloats relief;
    alignas(kAlignment) LaneFloats weight;
    alignas(kAlignment) LaneWords octaves; ///< 0: none is shown

    void putInto(std::size_t lane, std::size_t which, SpriteDetail& out) const
    {
        SpriteDetail::Phase& to = out.phases[which];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            to.at[axis] = at[axis][lane];
            to.u[axis] = u[axis][lane];
            to.v[axis] = v[axis][lane];
        }
        to.light = static_cast<std::uint32_t>(light[lane]);
        to.relief = relief[lane];
        to.weight = weight[lane];
        out.levels[which] = static_cast<std::uint8_t>(std::max(0, octaves[lane] - 1));
        out.shown[which] = octaves[lane] > 0 ? 1 : 0;
    }
};

/// Where sprites read a phase.
/// @param isFirst which of the two each lane reads
HWY_INLINE void findPhase(const SpriteDetailJob& job, const Places& places, const AdvectedPlaces<V>& from,
    hn::Mask<D> isFirst, LanePhases& out)
{
    const D d;
    const hn::RebindToSigned<D> di;
    const DetailField& detail = *job.detail;
    const auto shares = octaveShares(d, detail, from, places.finest);
    I octaves = hn::Zero(di);
    V size = hn::Set(d, static_cast<float>(DetailTexture::size(0)));
    for (std::size_t level = 0; level < shares.size(); ++level) {
        const auto isShown = hn::Lt(places.octaves, shares[level]);
        octaves = octaves - hn::BitCast(di, hn::VecFromMask(d, isShown));
        const auto edge = static_cast<float>(DetailTexture::size(static_cast<int>(level)));
        size = hn::IfThenElse(isShown, hn::Set(d, edge), size);
    }
    const V texelsPerMetre = size * detail.tilesPerMetre;
    const Vec3<V> shift = shiftOfChosen(d, detail, isFirst);
    // Each sprite reads a little beside its place: together they smooth what is linear over a texel alone.
    Vec3<V> at = from.place * texelsPerMetre + shift * size + places.jitter;
    const V tilesPerTexel = 1.0F / size; // exact
    const auto wrapped = [&](V texels) HWY_ATTR { return texels - hn::Floor(texels * tilesPerTexel) * size; };
    at = {wrapped(at.x), wrapped(at.y), wrapped(at.z)};
    const View& view = job.batch->view;
    const V texelsPerPixel = texelsPerMetre * places.metresPerPixel;
    const Vec3<V> light = along(from, job.lightDirection) * (texelsPerMetre * (kReliefReach * detail.wave));
    const LightBytesOf bytes(light);
    const V weight = ofChosen(d, isFirst, (*detail.phases)[0].weight, (*detail.phases)[1].weight);
    store(at, out.at[0], out.at[1], out.at[2], 0);
    store(along(from, view.right) * texelsPerPixel, out.u[0], out.u[1], out.u[2], 0);
    store(along(from, -view.up) * texelsPerPixel, out.v[0], out.v[1], out.v[2], 0);
    hn::Store(bytes.packed, di, out.light.data());
    hn::Store(weight * places.relief * bytes.scale * kRelief, d, out.relief.data());
    hn::Store(weight, d, out.weight.data());
    hn::Store(octaves, di, out.octaves.data());
}

/// What the sprites of some lanes have beside their phases.
struct alignas(kAlignment) LaneSmoke {
    alignas(kAlignment) LaneFloats strength;
    alignas(kAlignment) LaneFloats perMean;
    alignas(kAlignment) LaneFloats around;
    alignas(kAlignment) LaneFloats screenRelief;
};

/// Shows the detail of a sprite's centre all over it, as paintCoherent() shows it at a pixel, and leaves it without
/// any.
void showAtCentre(const DetailTexture& texture, SpriteDetail& detail, Sprite& sprite)
{
    const SpriteDetail::Phase& phase = detail.phases[0];
    const DetailTexture::Sample here = texture.sampleAt(detail.levels[0], phase.at[0], phase.at[1], phase.at[2]);
    detail.shown[0] = 0;
    const float even = here.value * phase.weight * detail.gain;
    const hn::CappedTag<float, 1> one;
    const float factor = hn::GetLane(alphaFactor(one, hn::Set(one, even), detail.strength));
    sprite.opacity = std::min(sprite.opacity * detail.perMean * factor, kMaxAlpha);
    const glm::vec3 way = LightBytes::unpacked(phase.light);
    const float shade = std::max(0.0F, glm::dot(here.slope, way) * phase.relief * detail.gain + 1.0F);
    const float around = std::max(0.0F, even * detail.around + 1.0F);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        sprite.direct[channel] *= shade;
        sprite.ambient[channel] *= around;
    }
}

/// Sprites of a radius below this show the detail of their centres in pictures that move.
constexpr float kPoint = 3.0F; // pixels

/// Finds the phases of some sprites, and puts all together.
struct DetailFinder {
    const SpriteDetailJob& job;
    std::size_t begin; ///< of the sprites of some lanes
    LaneSmoke smoke{};
    std::array<LanePhases, 2> phases{};

    HWY_INLINE void findSmoke(V body, V glowing, V metresPerPixel, V left)
    {
        /// How much less light from all around there is in folds, and how much more of the glow: a crust is dark, its
        /// cracks glow.
        constexpr float kOcclusion = 0.3F;
        constexpr float kGlowInFolds = 0.5F;
        const D d;
        const DetailField& detail = *job.detail;
        const V strength = (body * (1.0F - detail.edge) + detail.edge) * detail.strength;
        hn::Store(strength, d, smoke.strength.data());
        hn::Store(1.0F / meanOfFactor(strength), d, smoke.perMean.data());
        const V around = (1.0F - glowing) * kOcclusion - glowing * kGlowInFolds;
        hn::Store(left * around * detail.relief, d, smoke.around.data());
        hn::Store(hn::Div(left * (kRelief * detail.relief * kReliefReach * detail.wave), metresPerPixel), d,
            smoke.screenRelief.data());
    }

    /// @param random 0 to 1, for what chooses a phase
    HWY_INLINE void findPhases(const Places& places, V random)
    {
        const D d;
        const DetailField& detail = *job.detail;
        if (detail.mix == PhaseMix::Choose) {
            const ChosenPlaces<D> chosen = chosenPlaces(d, detail, places.at, random);
            findPhase(job, places, chosen.at, chosen.isFirst, phases[0]);
            return;
        }
        for (std::size_t which = 0; which < phases.size(); ++which) {
            const AdvectedPhase& phase = (*detail.phases)[which];
            if (phase.weight >= kMinPhaseWeight) {
                findPhase(job, places, advectedPlaces(d, phase.map, places.at), allIn(d, which), phases[which]);
            } else {
                phases[which].octaves.fill(0);
            }
        }
    }

    [[nodiscard]] PhaseBlend blendOf(const SpriteDetail& out) const
    {
        const DetailField& detail = *job.detail;
        if (detail.mix == PhaseMix::Choose) {
            return {out.phases[0].weight, 0.0F};
        }
        const float first = (*detail.phases)[0].weight;
        const float second = (*detail.phases)[1].weight;
        if (out.shown[0] != 0 && out.shown[1] != 0) {
            return {first, second};
        }
        return first < kMinPhaseWeight || second < kMinPhaseWeight ? PhaseBlend(std::max(first, second), 0.0F)
                                                                   : PhaseBlend();
    }

    void finish(std::size_t lane)
    {
        const DetailField& detail = *job.detail;
        SpriteBatch& batch = *job.batch;
        SpriteDetail& out = batch.details[begin + lane];
        out.shown[0] = out.shown[1] = 0;
        constexpr float kNothing = 0.01F;
        if (batch.depth[begin + lane] == SpriteBatch::kHidden || !(smoke.strength[lane] > kNothing)) {
            return;
        }
        const std::size_t shown = detail.mix == PhaseMix::Choose ? 1 : 2;
        for (std::size_t which = 0; which < shown; ++which) {
            phases[which].putInto(lane, which, out);
        }
        const PhaseBlend blend = blendOf(out);
        out.gain = blend.gain;
        out.flat = blend.flat;
        out.bend = blend.bend;
        out.strength = smoke.strength[lane];
        out.perMean = smoke.perMean[lane];
        out.around = smoke.around[lane];
        out.screenRelief = smoke.screenRelief[lane];
        Sprite& sprite = batch.sprites[begin + lane];
        if (detail.mix == PhaseMix::Choose && out.shown[0] != 0 && sprite.halfWidth < kPoint) {
            showAtCentre(*detail.texture, out, sprite);
        }
    }
};

void findDetail(const SpriteDetailJob& job, const SpriteSurroundings& surroundings, std::size_t begin)
{
    constexpr std::uint32_t kOctaveStream = 0x0c7a;
    constexpr std::uint32_t kJitterStream = 0x717e;
    constexpr std::uint32_t kPhaseStream = 0x9a5e;
    const D d;
    const hn::RebindToUnsigned<D> du;
    const DetailField& detail = *job.detail;
    const Particles& particles = *job.particles;
    const View& view = job.batch->view;
    DetailFinder finder{job, begin};
    for (std::size_t i = 0; i < kSpriteBlock; i += hn::Lanes(d)) {
        finder.begin = begin + i;
        const U key = hn::Load(du, particles.key.data() + begin + i);
        const V body = hn::Load(d, surroundings.body.data() + i);
        // Relief goes earlier than strength where smoke is thin.
        const V left = body * (1.0F - 0.5F * detail.edge) + 0.5F * detail.edge;
        const Vec3<V> at = load(d, particles.x, particles.y, particles.z, begin + i);
        const V metresPerPixel = dot(at - view.eye, view.forward) * (1.0F / view.focal);
        V finest = metresPerPixel;
        if (detail.mix == PhaseMix::Choose) {
            const V radius = hn::Load(d, surroundings.radius.data() + i);
            const auto isPoint = hn::Lt(radius, hn::Set(d, kPoint));
            finest = metresPerPixel * hn::IfThenElse(isPoint, radius, hn::Set(d, 1.0F));
        }
        const auto jitter = [&](std::uint32_t axis)
                                HWY_ATTR { return unitStream(d, key, kJitterStream + axis) - 0.5F; };
        const Places places{at, {jitter(0), jitter(1), jitter(2)}, unitStream(d, key, kOctaveStream), metresPerPixel,
            finest, left * detail.relief};
        finder.findSmoke(body, hn::Load(d, surroundings.glowing.data() + i), metresPerPixel, left);
        finder.findPhases(places, unitStream(d, key, kPhaseStream));
        for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
            finder.finish(lane);
        }
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(findDetail);

void findSpriteDetail(const SpriteDetailJob& job, const SpriteSurroundings& surroundings, std::size_t begin)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(findDetail);
    kernel(job, surroundings, begin);
}

} // namespace fumage
#endif
