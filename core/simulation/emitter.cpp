#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/simulation/emitter.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/math-inl.h"
#include "core/base/math.h"
#include "core/simulation/emitter.h"
#include "core/simulation/streams.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using DU = hn::RebindToUnsigned<D>;
using VU = hn::Vec<DU>;

struct Triple {
    V x, y, z;
};

HWY_INLINE Triple broadcast(D d, const glm::vec3& v)
{
    return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}

/// a + b * factor
HWY_INLINE Triple add(D d, const Triple& a, const glm::vec3& b, V factor)
{
    return {mulAdd(hn::Set(d, b.x), factor, a.x), mulAdd(hn::Set(d, b.y), factor, a.y), mulAdd(hn::Set(d, b.z), factor, a.z)};
}

HWY_INLINE V signedStream(D d, VU key, std::uint32_t stream)
{
    return mulAdd(hn::Set(d, 2.0F), unitStream(d, key, stream), hn::Set(d, -1.0F));
}

/// The vector form of birthKey().
HWY_INLINE VU birthKeys(DU du, std::uint32_t seed, VU low, VU high)
{
    const VU first = mixBitsV(du, hn::Add(low, hn::Set(du, seed * 0x9e3779b9U)));
    return mixBitsV(du, hn::Xor(first, hn::Add(hn::Mul(high, hn::Set(du, 0x85ebca6bU)), hn::Set(du, seed))));
}

HWY_INLINE Triple birthPosition(D d, const BirthPlace& place, VU key)
{
    const Emitter& emitter = place.emitter;
    const V u = signedStream(d, key, kBirthAcross);
    const V v = signedStream(d, key, kBirthAlong);
    const Triple centre = broadcast(d, emitter.position);
    if (emitter.shape == EmitterShape::Rectangle) {
        const V across = hn::Mul(u, hn::Set(d, 0.5F * emitter.width));
        const V along = hn::Mul(v, hn::Set(d, 0.5F * emitter.depth));
        return add(d, add(d, centre, place.basis.across, across), place.basis.along, along);
    }
    V sine = hn::Zero(d);
    V cosine = hn::Zero(d);
    sinCos(d, hn::Mul(u, hn::Set(d, kPi)), sine, cosine);
    const V body = unitStream(d, key, kBirthBody);
    if (emitter.shape == EmitterShape::Disc) {
        const V r = hn::Mul(hn::Set(d, emitter.radius), hn::Sqrt(body));
        return add(d, add(d, centre, place.basis.across, hn::Mul(r, cosine)), place.basis.along, hn::Mul(r, sine));
    }
    // Uniform in a ball: height uniform on the sphere (Archimedes), radius by the cube root.
    const V level = hn::Sqrt(hn::Max(hn::Zero(d), hn::Sub(hn::Set(d, 1.0F), hn::Mul(v, v))));
    const V cubeRoot = exponential(d, hn::Mul(logarithm(d, body), hn::Set(d, 1.0F / 3.0F)));
    const V r = hn::Mul(hn::Set(d, emitter.radius), cubeRoot);
    const Triple flat = add(d, add(d, centre, place.basis.across, hn::Mul(r, hn::Mul(level, cosine))), place.basis.along, hn::Mul(r, hn::Mul(level, sine)));
    return add(d, flat, emitter.normal, hn::Mul(r, v));
}

HWY_INLINE Triple birthVelocity(D d, const BirthPlace& place, VU key)
{
    const Emitter& emitter = place.emitter;
    Triple n = broadcast(d, emitter.normal);
    if (place.spread > 0.0F) {
        V tiltSine = hn::Zero(d);
        V tiltCosine = hn::Zero(d);
        V turnSine = hn::Zero(d);
        V turnCosine = hn::Zero(d);
        sinCos(d, hn::Mul(hn::Set(d, place.spread), hn::Sqrt(unitStream(d, key, kBirthConeAngle))), tiltSine, tiltCosine);
        sinCos(d, hn::Mul(hn::Set(d, kPi), signedStream(d, key, kBirthConeTurn)), turnSine, turnCosine);
        n = {hn::Mul(n.x, tiltCosine), hn::Mul(n.y, tiltCosine), hn::Mul(n.z, tiltCosine)};
        n = add(d, add(d, n, place.basis.across, hn::Mul(tiltSine, turnCosine)), place.basis.along, hn::Mul(tiltSine, turnSine));
    }
    const V random = hn::Set(d, emitter.velocityRandomness);
    const V calm = hn::Set(d, 1.0F - emitter.velocityRandomness);
    const V speed = hn::Set(d, emitter.speed);
    return {hn::Mul(hn::Mul(n.x, mulAdd(random, signedStream(d, key, kBirthVelocityX), calm)), speed),
        hn::Mul(hn::Mul(n.y, mulAdd(random, unitStream(d, key, kBirthVelocityY), calm)), speed),
        hn::Mul(hn::Mul(n.z, mulAdd(random, signedStream(d, key, kBirthVelocityZ), calm)), speed)};
}

void bear(const BirthPlace& place, std::int64_t randomIndex, std::int32_t step, std::size_t slot, std::size_t count, Particles& particles)
{
    const D d;
    const DU du;
    const hn::RebindToSigned<D> di;
    const std::size_t lanes = hn::Lanes(d);
    // Neighbours of the last few may be another thread's: what does not fill a vector goes through memory of its own.
    const auto store = [lanes](auto tag, auto values, auto* to, std::size_t n) HWY_ATTR {
        if (n == lanes) {
            hn::StoreU(values, tag, to);
            return;
        }
        HWY_ALIGN hn::TFromD<decltype(tag)> buffer[HWY_MAX_BYTES / sizeof(float)];
        hn::Store(values, tag, buffer);
        std::copy_n(buffer, n, to);
    };
    for (std::size_t done = 0; done < count; done += lanes) {
        const auto index = static_cast<std::uint64_t>(randomIndex) + done;
        const auto start = static_cast<std::uint32_t>(index);
        const VU low = hn::Add(hn::Iota(du, 0U), hn::Set(du, start));
        const VU carry = hn::VecFromMask(du, hn::Lt(low, hn::Set(du, start))); // all ones, which is -1, where the low half has wrapped
        const VU high = hn::Sub(hn::Set(du, static_cast<std::uint32_t>(index >> 32U)), carry);
        const VU key = birthKeys(du, place.emitter.seed, low, high);
        const Triple v = birthVelocity(d, place, key);
        Triple p = birthPosition(d, place, key);
        if (place.emitter.subframe) {
            const V ahead = hn::Mul(hn::Set(d, place.dt), unitStream(d, key, kBirthBetweenSteps));
            p = {mulAdd(v.x, ahead, p.x), mulAdd(v.y, ahead, p.y), mulAdd(v.z, ahead, p.z)};
        }
        const std::size_t n = std::min(lanes, count - done);
        const std::size_t to = slot + done;
        store(d, p.x, particles.x.data() + to, n);
        store(d, p.y, particles.y.data() + to, n);
        store(d, p.z, particles.z.data() + to, n);
        store(d, v.x, particles.vx.data() + to, n);
        store(d, v.y, particles.vy.data() + to, n);
        store(d, v.z, particles.vz.data() + to, n);
        store(du, key, particles.key.data() + to, n);
        store(di, hn::Set(di, step), particles.birthStep.data() + to, n);
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(bear);

BirthPlace::BirthPlace(const Emitter& from, float effectDt)
    : emitter(from)
    , basis(planeBasis(from.normal))
    , spread(radians(from.spread))
    , dt(effectDt)
{
}

void bearParticles(const BirthPlace& place, std::int64_t randomIndex, std::int32_t step, std::size_t slot, std::size_t count, Particles& particles)
{
    HWY_DYNAMIC_DISPATCH(bear)
    (place, randomIndex, step, slot, count, particles);
}

} // namespace fumage
#endif
