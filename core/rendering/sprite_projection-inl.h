// Included once per SIMD target: the half of making sprites that works on vectors of particles.

#if defined(FUMAGE_SPRITE_PROJECTION_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_SPRITE_PROJECTION_INL_H
#undef FUMAGE_SPRITE_PROJECTION_INL_H
#else
#define FUMAGE_SPRITE_PROJECTION_INL_H
#endif

#include "core/base/hash-inl.h"
#include "core/base/math-inl.h"
#include "core/base/math.h"
#include "core/lighting/particle_light-inl.h"
#include "core/rendering/sprite_job.h"
#include "core/simulation/ages-inl.h"
#include "core/simulation/streams.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Screen data of a block of particles, between the vector and the scalar half of the work.
struct SpriteBlock {
    alignas(64) float x[kSpriteBlock];
    alignas(64) float y[kSpriteBlock];
    alignas(64) float depth[kSpriteBlock];
    alignas(64) float radius[kSpriteBlock];
    alignas(64) float sine[kSpriteBlock];
    alignas(64) float cosine[kSpriteBlock];
    alignas(64) float slice[kSpriteBlock];
    alignas(64) float stretchX[kSpriteBlock]; ///< velocity on the screen, pixels/s
    alignas(64) float stretchY[kSpriteBlock];
    /// What makes a disc of the particle: inverse axes on the screen, symmetric
    alignas(64) float shapeXX[kSpriteBlock];
    alignas(64) float shapeXY[kSpriteBlock];
    alignas(64) float shapeYY[kSpriteBlock];
    alignas(64) float area[kSpriteBlock]; ///< over that of a disc
    LitBlock lit;
};

/// Turns of hours leave the range of the sine; the rest of a division by a full turn brings them back.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE SineCosine<V> sinCosOfTurns(D d, V angle)
{
    const V turns = hn::Round(angle * (1.0F / kTau));
    return sinCos(d, angle - turns * kTau);
}

/// How old particles are.
template <class V>
struct SpriteAge {
    V steps;
    V seconds;
};

/// What a rate has added up to over the life of particles.
/// @param sums of whole ages, see sumOverAges(); empty: the rate is constant
/// @param rate a second, where it is
template <class D, class V = hn::VFromD<D>>
HWY_INLINE V summedUp(D d, const std::vector<float>& sums, float rate, const SpriteAge<V>& age)
{
    if (sums.empty()) {
        return age.seconds * rate;
    }
    const hn::RebindToSigned<D> di;
    // Places where nobody lives have any age.
    const V last = hn::Set(d, static_cast<float>(sums.size() - 2));
    const V whole = hn::Min(hn::Max(hn::Floor(age.steps), hn::Zero(d)), last);
    const auto index = hn::ConvertTo(di, whole);
    const V before = hn::GatherIndex(d, sums.data(), index);
    const V after = hn::GatherIndex(d, sums.data() + 1, index);
    return (age.steps - whole) * (after - before) + before;
}

/// Angle of particles about the line of sight; y runs down on the screen.
template <class D, class VU, class V = hn::VFromD<D>>
HWY_INLINE V angleOf(D d, const SpriteJob& job, std::size_t at, VU key, const SpriteAge<V>& age)
{
    const Particles& particles = *job.particles;
    const V turned = signedStream(d, key, kRotationStream) * job.rotationVariance;
    const V own = signedStream(d, key, kSpinStream);
    const V angle = job.spun.empty() && job.spunVariance.empty()
        ? (own * job.spinVariance + job.spin) * age.seconds + turned
        : own * summedUp(d, job.spunVariance, job.spinVariance, age) + summedUp(d, job.spun, job.spin, age) + turned;
    if (!particles.rolls()) {
        return angle;
    }
    return dot(load(d, particles.rollX, particles.rollY, particles.rollZ, at), job.view.forward) * job.roll + angle;
}

/// The slice of the noise that particles show now, between 0 and the number of slices.
template <class D, class VU, class V = hn::VFromD<D>>
HWY_INLINE V sliceOf(D d, const SpriteJob& job, VU key, const SpriteAge<V>& age)
{
    const auto slices = static_cast<float>(job.texture->slices());
    const V moved =
        summedUp(d, job.boiled, job.textureSlicesPerSecond / slices, age) + unitStream(d, key, kSliceStream);
    return (moved - hn::Floor(moved)) * slices;
}

/// The ellipse of deformed particles on the screen: S, the part of their tensor C in the camera's plane, has the
/// squares of its axes a and b as eigenvalues, and S^(-1/2) = 1/b + (1/a - 1/b) (S - b^2) / (a^2 - b^2) makes a disc of
/// it.
template <class D>
HWY_INLINE void projectShape(D d, const SpriteJob& job, std::size_t at, std::size_t i, SpriteBlock& block)
{
    using V = hn::Vec<D>;
    const Particles& p = *job.particles;
    const auto column = [&](const AlignedArray<float>& values) HWY_ATTR { return hn::Load(d, values.data() + at); };
    const Vec3<V> x{column(p.shapeXX), column(p.shapeXY), column(p.shapeXZ)};
    const Vec3<V> y{x.y, column(p.shapeYY), column(p.shapeYZ)};
    const Vec3<V> z{x.z, y.z, column(p.shapeZZ)};
    const auto through = [&](const glm::vec3& way) HWY_ATTR { return Vec3<V>{dot(x, way), dot(y, way), dot(z, way)}; };
    const Vec3<V> right = through(job.view.right);
    const float round = 1.0F - job.deformation;
    const V xx = job.deformation * dot(right, job.view.right) + round;
    const V yy = job.deformation * dot(through(job.view.up), job.view.up) + round;
    const V xy = hn::Neg(job.deformation * dot(right, job.view.up)); // y runs down
    const V half = 0.5F * (xx + yy);
    const V skew = 0.5F * (xx - yy);
    const V apart = hn::Sqrt(skew * skew + xy * xy);
    const V least = hn::Set(d, 1.0F / job.deformationLimit);
    const V most = hn::Set(d, job.deformationLimit);
    const auto axis = [&](V square)
                          HWY_ATTR { return hn::Min(hn::Max(hn::Sqrt(hn::Max(square, hn::Zero(d))), least), most); };
    const V longer = axis(half + apart);
    const V shorter = axis(half - apart);
    constexpr float kNoDifference = 1e-6F;
    const V slope = (1.0F / longer - 1.0F / shorter) / hn::Max(2.0F * apart, hn::Set(d, kNoDifference));
    const V rest = 1.0F / shorter - slope * (half - apart);
    hn::Store(rest + slope * xx, d, block.shapeXX + i);
    hn::Store(slope * xy, d, block.shapeXY + i);
    hn::Store(rest + slope * yy, d, block.shapeYY + i);
    hn::Store(longer * shorter, d, block.area + i);
}

inline void projectBlock(const SpriteJob& job, std::size_t begin, SpriteBlock& block)
{
    using D = hn::ScalableTag<float>;
    using V = hn::Vec<D>;
    const D d;
    const hn::RebindToUnsigned<D> du;
    const Particles& particles = *job.particles;
    const View& view = job.view;
    for (std::size_t i = 0; i < kSpriteBlock; i += hn::Lanes(d)) {
        const std::size_t at = begin + i;
        const Vec3<V> position = load(d, particles.x, particles.y, particles.z, at);
        const Vec3<V> way = position - view.eye;
        const V depth = dot(way, view.forward);
        const V perMetre = view.focal / hn::Max(depth, hn::Set(d, kNear));
        hn::Store(dot(way, view.right) * perMetre + 0.5F * static_cast<float>(view.width), d, block.x + i);
        hn::Store(0.5F * static_cast<float>(view.height) - dot(way, view.up) * perMetre, d, block.y + i);
        hn::Store(depth, d, block.depth + i);
        hn::Store(hn::Load(d, job.appearance->radius.data() + at) * perMetre, d, block.radius + i);

        const auto key = hn::Load(du, particles.key.data() + at);
        const V steps = agesInSteps(d, particles, at, key, job.step, job.bornBetweenSteps);
        const SpriteAge<V> age{steps, steps * job.dt};
        const SineCosine<V> turn = sinCosOfTurns(d, angleOf(d, job, at, key, age));
        hn::Store(turn.sine, d, block.sine + i);
        hn::Store(turn.cosine, d, block.cosine + i);
        hn::Store(sliceOf(d, job, key, age), d, block.slice + i);
        if (job.colours.glows) {
            findGlow(d, job.colours, particles, at, key, age.seconds, i, block.lit);
        }
        if (job.stretch > 0.0F) {
            const Vec3<V> velocity = load(d, particles.vx, particles.vy, particles.vz, at);
            hn::Store(dot(velocity, view.right) * perMetre, d, block.stretchX + i);
            hn::Store(hn::Neg(dot(velocity, view.up) * perMetre), d, block.stretchY + i);
        }
        if (job.deforms) {
            projectShape(d, job, at, i, block);
        }
        placeInLight(d, job.light->shape, position, i, block.lit);
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
