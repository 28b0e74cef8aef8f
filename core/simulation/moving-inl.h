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

/// Three independent random int32 as float, for one particle and step: three rounds of multiply and shift over key XOR
/// step key.
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

/// Of a way by drag: see StepConstants.
struct FlightWeights {
    V before, after;
};

/// (1 - e^-x) / x, and what it lacks of 1 over x: for small x by their series, whose next term is below what a float
/// sees.
HWY_INLINE void dragMeans(D d, V x, V& mean, V& lacking)
{
    constexpr float kSmall = 0.1F;
    const V safe = hn::Max(x, hn::Set(d, kSmall));
    const V direct = (1.0F - exponential(d, hn::Neg(safe))) / safe;
    const V series = 0.5F
        * (1.0F
            - x * (1.0F / 3.0F) * (1.0F - x * (1.0F / 4.0F) * (1.0F - x * (1.0F / 5.0F) * (1.0F - x * (1.0F / 6.0F)))));
    const auto isSmall = hn::Lt(x, hn::Set(d, kSmall));
    mean = hn::IfThenElse(isSmall, 1.0F - x * series, direct);
    lacking = hn::IfThenElse(isSmall, series, (1.0F - direct) / safe);
}

/// The time of a step, for what lives through the whole of it.
struct WholeStep {
    template <class T>
    HWY_INLINE T operator()(const T& amount) const
    {
        return amount;
    }
    /// A step's change of velocity.
    static HWY_INLINE Vec3<V> dragged(D /*d*/, const StepConstants& /*constants*/, const Vec3<V>& change)
    {
        return change;
    }
    [[nodiscard]] static HWY_INLINE FlightWeights flight(D d, const StepConstants& constants)
    {
        return {hn::Set(d, constants.flightBefore), hn::Set(d, constants.flightAfter)};
    }
    [[nodiscard]] static HWY_INLINE SineCosine<V> rotation(D d, const StepConstants& constants)
    {
        return {hn::Set(d, constants.rotationSin), hn::Set(d, constants.rotationCos)};
    }
};

/// The same for what was born during the step: each lane has a share of it.
struct PartOfStep {
    V share;

    HWY_INLINE V operator()(V amount) const { return amount * share; }
    HWY_INLINE V operator()(float amount) const { return amount * share; }
    HWY_INLINE Vec3<V> operator()(const Vec3<V>& amount) const { return amount * share; }
    /// Drag takes and forces give less in the second half of a step than in the first.
    [[nodiscard]] HWY_INLINE Vec3<V> dragged(D d, const StepConstants& constants, const Vec3<V>& change) const
    {
        if (constants.drag == 0.0F) {
            return change * share;
        }
        V mean, lacking;
        dragMeans(d, share * constants.dragOfStep, mean, lacking);
        return change * (share * mean * (constants.dragOfStep / constants.drag));
    }
    [[nodiscard]] HWY_INLINE FlightWeights flight(D d, const StepConstants& constants) const
    {
        if (constants.drag == 0.0F) {
            return WholeStep::flight(d, constants);
        }
        V mean, lacking;
        const V x = share * constants.dragOfStep;
        dragMeans(d, x, mean, lacking);
        const V after = lacking / mean;
        return {mean - after * (1.0F - x * mean), after};
    }
    [[nodiscard]] HWY_INLINE SineCosine<V> rotation(D d, const StepConstants& constants) const
    {
        return sinCos(d, constants.rotation * share);
    }
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

/// The velocity after a step's acceleration: wind and gravity, buoyancy and the pull towards the axis, all with the
/// same randomness, and drag.
/// @param lift m/s a step: what buoyancy gives this particle
template <class Time>
HWY_INLINE Vec3<V> accelerated(D d, const StepConstants& constants, const Time& time, VU key, V lift,
    const Vec3<V>& position, const Vec3<V>& velocity)
{
    const Vec3<V> away = position - constants.pivot;
    const Vec3<V> own{-constants.pull * away.x, lift, -constants.pull * away.z};
    const Vec3<V> draw = signedDraws(d, key, hn::Set(DU(), constants.key));
    const Vec3<V> common = draw * constants.random + constants.steady;
    const Vec3<V> share = draw * constants.randomShare + glm::vec3(constants.steadyShare);
    const Vec3<V> kick = common + own * share;
    const Vec3<V> v =
        velocity + time.dragged(d, constants, constants.drag == 0.0F ? kick : kick - velocity * constants.drag);
    const V most = hn::Set(d, kMaxSpeed);
    const auto bounded = [&](V speed) HWY_ATTR { return hn::Min(hn::Max(speed, hn::Neg(most)), most); };
    return {bounded(v.x), bounded(v.y), bounded(v.z)};
}

/// The velocity by which a particle gets in a step from where it was to where it is, of those before and after
/// accelerated(): with drag the mean of the exact solution, without it that of the semi-implicit Euler step, eq. X,
/// which is the one after.
template <class Time>
HWY_INLINE Vec3<V> flown(
    D d, const StepConstants& constants, const Time& time, const Vec3<V>& before, const Vec3<V>& after)
{
    if (constants.drag == 0.0F) {
        return after;
    }
    const FlightWeights weights = time.flight(d, constants);
    return before * weights.before + after * weights.after;
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
