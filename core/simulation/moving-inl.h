// Included once per SIMD target: what all steps of particles share.

#if defined(FUMAGE_MOVING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_MOVING_INL_H
#undef FUMAGE_MOVING_INL_H
#else
#define FUMAGE_MOVING_INL_H
#endif

#include "core/base/hash-inl.h"
#include "core/base/math-inl.h"
#include "core/base/vector-inl.h"
#include "core/simulation/ages-inl.h"
#include "core/simulation/step.h"
#include "core/simulation/streams.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE::stepping {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using DU = hn::RebindToUnsigned<D>;
using VU = hn::Vec<DU>;

/// Three independent random int32 as float, for one particle and step: three rounds of multiply and shift over key XOR step key.
HWY_INLINE Vec3<V> signedDraws(D d, VU key, VU stepKey)
{
    VU bits = (key ^ stepKey) * kMixFactor1;
    bits = (bits ^ hn::ShiftRight<15>(bits)) * kMixFactor2;
    bits = bits ^ hn::ShiftRight<16>(bits);
    const V x = signedValue(d, bits);
    bits = bits * kPrime1;
    bits = bits ^ hn::ShiftRight<15>(bits);
    const V y = signedValue(d, bits);
    bits = bits * kPrime2;
    bits = bits ^ hn::ShiftRight<16>(bits);
    return {x, y, signedValue(d, bits)};
}

/// The time of a step, for what lives through the whole of it.
struct WholeStep {
    template <class T>
    HWY_INLINE T operator()(const T& amount) const
    {
        return amount;
    }
    [[nodiscard]] static HWY_INLINE SineCosine<V> rotation(D d, const StepConstants& constants) { return {hn::Set(d, constants.rotationSin), hn::Set(d, constants.rotationCos)}; }
};

/// The same for what was born during the step: each lane has a share of it.
struct PartOfStep {
    V share;

    HWY_INLINE V operator()(V amount) const { return amount * share; }
    HWY_INLINE V operator()(float amount) const { return amount * share; }
    HWY_INLINE Vec3<V> operator()(const Vec3<V>& amount) const { return amount * share; }
    [[nodiscard]] HWY_INLINE SineCosine<V> rotation(D d, const StepConstants& constants) const { return sinCos(d, constants.rotation * share); }
};

/// Turned about the vertical, from +z towards +x.
HWY_INLINE Vec3<V> rotated(const SineCosine<V>& angle, const Vec3<V>& v)
{
    return {angle.cosine * v.x + angle.sine * v.z, v.y, angle.cosine * v.z - angle.sine * v.x};
}

/// A place turned with the whole cloud.
HWY_INLINE Vec3<V> turnedAboutPivot(const SineCosine<V>& angle, const StepConstants& constants, const Vec3<V>& place)
{
    const Vec3<V> away = rotated(angle, place - constants.pivot);
    return {away.x + constants.pivot.x, place.y, away.z + constants.pivot.z};
}

/// The velocity after a step's acceleration: wind and gravity, buoyancy and the pull towards the axis, all with the same randomness, and drag.
/// @param lift m/s a step: what buoyancy gives this particle
template <class Time>
HWY_INLINE Vec3<V> accelerated(D d, const StepConstants& constants, const Time& time, VU key, V lift, const Vec3<V>& position, const Vec3<V>& velocity)
{
    const Vec3<V> away = position - constants.pivot;
    const Vec3<V> own{-constants.pull * away.x, lift, -constants.pull * away.z};
    const Vec3<V> draw = signedDraws(d, key, hn::Set(DU(), constants.key));
    const Vec3<V> common = draw * constants.random + constants.steady;
    const Vec3<V> share = draw * constants.randomShare + glm::vec3(constants.steadyShare);
    const Vec3<V> kick = common + own * share;
    const Vec3<V> v = velocity + time(constants.drag == 0.0F ? kick : kick - velocity * constants.drag);
    const V most = hn::Set(d, kMaxSpeed);
    const auto bounded = [&](V speed) HWY_ATTR { return hn::Min(hn::Max(speed, hn::Neg(most)), most); };
    return {bounded(v.x), bounded(v.y), bounded(v.z)};
}

/// How much more than others a particle is lifted by its heat.
HWY_INLINE V heatDeviation(D d, const StepConstants& constants, VU key)
{
    return constants.heatVariance * (0.5F - unitStream(d, key, kHeatStream));
}

/// The state of particles that a step changes.
struct Moving {
    Vec3<V> position;
    Vec3<V> velocity;
    Vec3<V> roll;

    template <bool kTurns>
    static HWY_INLINE Moving from(D d, const Particles& p, std::size_t i)
    {
        Moving out{load(d, p.x, p.y, p.z, i), load(d, p.vx, p.vy, p.vz, i), uniform(hn::Zero(d))};
        if constexpr (kTurns) {
            out.roll = load(d, p.rollX, p.rollY, p.rollZ, i);
        }
        return out;
    }

    template <bool kTurns>
    HWY_INLINE void to(Particles& p, std::size_t i) const
    {
        store(position, p.x, p.y, p.z, i);
        store(velocity, p.vx, p.vy, p.vz, i);
        if constexpr (kTurns) {
            store(roll, p.rollX, p.rollY, p.rollZ, i);
        }
    }
};

} // namespace fumage::HWY_NAMESPACE::stepping
HWY_AFTER_NAMESPACE();

#endif
