#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/simulation/step_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/simulation/moving-inl.h"
#include "core/simulation/swirls-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using namespace stepping;

/// Eq. III to V and IX to XII alone. Kept apart from the whole model so that its loop is short enough to pipeline.
void stepPlain(const StepConstants& constants, Particles& particles, std::size_t chunk)
{
    const D d;
    const DU du;
    const std::size_t begin = chunk * Particles::kChunk;
    const std::size_t end = begin + Particles::kChunk;
    float* HWY_RESTRICT x = particles.x.data();
    float* HWY_RESTRICT y = particles.y.data();
    float* HWY_RESTRICT z = particles.z.data();
    float* HWY_RESTRICT vx = particles.vx.data();
    float* HWY_RESTRICT vy = particles.vy.data();
    float* HWY_RESTRICT vz = particles.vz.data();
    const std::uint32_t* HWY_RESTRICT key = particles.key.data();
    const V dt = hn::Set(d, constants.dt);
    const VU stepKey = hn::Set(du, constants.key);
    const Vec3<V> steady = broadcast(d, constants.steady);
    const Vec3<V> random = broadcast(d, constants.random);
    for (std::size_t i = begin; i < end; i += hn::Lanes(d)) {
        const Vec3<V> draw = signedDraws(d, hn::Load(du, key + i), stepKey);
        const Vec3<V> v = load(d, vx, vy, vz, i) + (random * draw + steady);
        store(v, vx, vy, vz, i);
        store(load(d, x, y, z, i) + v * dt, x, y, z, i);
    }
}

/// 0 at birth to 1 at the onset, smooth at both ends.
HWY_INLINE V onsetRamp(D d, const StepConstants& constants, V age)
{
    if (constants.onset <= 0.0F) {
        return hn::Set(d, 1.0F);
    }
    return smoothStep(clamp01(d, age * (1.0F / constants.onset)));
}

/// What a step, or the part of it that they have lived through, makes of particles.
template <bool kTurns, class Time>
HWY_INLINE Moving stepped(D d, const StepConstants& constants, const Time& time, VU key, V age, Moving at)
{
    Vec3<V>& p = at.position;
    if (constants.vortexStrength != 0.0F) {
        p = turnedByVortex(d, constants, time, p);
    }
    const V lift =
        constants.buoyancy * (1.0F + heatDeviation(d, constants, key)) * exponential(d, -constants.cooling * age);
    const Vec3<V> before = at.velocity;
    at.velocity = accelerated(d, constants, time, key, lift, p, before);
    Vec3<V> carried = flown(d, constants, time, before, at.velocity);
    Vec3<V> vorticity = uniform(hn::Zero(d));
    if (constants.octaves > 0) {
        addTurbulence<kTurns>(d, constants, p, onsetRamp(d, constants, age), carried, vorticity);
    }
    if (constants.ringStrength != 0.0F) {
        addRings<kTurns>(d, constants, p, carried, vorticity);
    }
    if constexpr (kTurns) {
        at.roll = at.roll + vorticity * time(0.5F * constants.dt); // a small body in a flow turns at half its vorticity
    }
    p = p + carried * time(constants.dt);
    if (constants.rotation != 0.0F) {
        const SineCosine<V> angle = time.rotation(d, constants);
        p = turnedAboutPivot(angle, constants, p);
        at.velocity = rotated(angle, at.velocity);
    }
    return at;
}

template <bool kTurns>
HWY_INLINE void stepWholeWith(const StepConstants& constants, Particles& particles, std::size_t chunk)
{
    const D d;
    const std::size_t begin = chunk * Particles::kChunk;
    const std::size_t end = begin + Particles::kChunk;
    for (std::size_t i = begin; i < end; i += hn::Lanes(d)) {
        const VU key = hn::Load(DU(), particles.key.data() + i);
        const V age = agesInSteps(d, particles, i, key, constants.step, constants.betweenSteps) * constants.dt;
        const Moving before = Moving::from<kTurns>(d, particles, i);
        stepped<kTurns>(d, constants, WholeStep(), key, age, before).template to<kTurns>(particles, i);
    }
}

/// Slots [first, last); neighbours in the same vectors stay as they are.
template <bool kTurns>
HWY_INLINE void stepNewParticlesWith(
    const StepConstants& constants, Particles& particles, std::size_t first, std::size_t last)
{
    const D d;
    for (std::size_t i = first / hn::Lanes(d) * hn::Lanes(d); i < last; i += hn::Lanes(d)) {
        const VU key = hn::Load(DU(), particles.key.data() + i);
        const V share = agesInSteps(d, particles, i, key, constants.step, true);
        const Moving before = Moving::from<kTurns>(d, particles, i);
        const Moving after = stepped<kTurns>(d, constants, PartOfStep{share}, key, share * constants.dt, before);
        const auto isNew = hn::AndNot(hn::FirstN(d, first - std::min(first, i)), hn::FirstN(d, last - i));
        const auto chosen = [&](const Vec3<V>& a, const Vec3<V>& b) HWY_ATTR {
            return Vec3<V>{
                hn::IfThenElse(isNew, a.x, b.x), hn::IfThenElse(isNew, a.y, b.y), hn::IfThenElse(isNew, a.z, b.z)};
        };
        const Moving kept{chosen(after.position, before.position), chosen(after.velocity, before.velocity),
            chosen(after.roll, before.roll)};
        kept.to<kTurns>(particles, i);
    }
}

void stepWhole(const StepConstants& constants, Particles& particles, std::size_t chunk)
{
    if (particles.rolls()) {
        stepWholeWith<true>(constants, particles, chunk);
    } else {
        stepWholeWith<false>(constants, particles, chunk);
    }
}

void stepJustBorn(const StepConstants& constants, Particles& particles, std::size_t first, std::size_t last)
{
    if (particles.rolls()) {
        stepNewParticlesWith<true>(constants, particles, first, last);
    } else {
        stepNewParticlesWith<false>(constants, particles, first, last);
    }
}

void evaluateTurbulence(const StepConstants& constants, const std::array<std::span<const float>, 3>& from,
    const std::array<std::span<float>, 3>& to)
{
    const D d;
    constexpr std::size_t kRoom = HWY_MAX_BYTES / sizeof(float);
    HWY_ALIGN float place[3][kRoom] = {};
    HWY_ALIGN float velocity[3][kRoom];
    for (std::size_t i = 0; i < from[0].size(); i += hn::Lanes(d)) {
        const std::size_t n = std::min(hn::Lanes(d), from[0].size() - i);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::copy_n(from[axis].data() + i, n, place[axis]);
        }
        Vec3<V> sum = uniform(hn::Zero(d));
        Vec3<V> none = sum;
        addTurbulence<false>(d, constants, load(d, place[0], place[1], place[2], 0), hn::Set(d, 1.0F), sum, none);
        store(sum, velocity[0], velocity[1], velocity[2], 0);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::copy_n(velocity[axis], n, to[axis].data() + i);
        }
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(stepPlain);
HWY_EXPORT(stepWhole);
HWY_EXPORT(stepJustBorn);
HWY_EXPORT(evaluateTurbulence);

void stepChunk(const StepConstants& constants, Particles& particles, std::size_t chunk)
{
    const auto step = constants.plain ? HWY_DYNAMIC_DISPATCH(stepPlain) : HWY_DYNAMIC_DISPATCH(stepWhole);
    step(constants, particles, chunk);
}

void stepNewParticles(const StepConstants& constants, Particles& particles, std::size_t first, std::size_t last)
{
    const auto step = HWY_DYNAMIC_DISPATCH(stepJustBorn);
    step(constants, particles, first, last);
}

void turbulenceAt(const StepConstants& constants, std::span<const float> x, std::span<const float> y,
    std::span<const float> z, std::span<float> vx, std::span<float> vy, std::span<float> vz)
{
    const auto evaluate = HWY_DYNAMIC_DISPATCH(evaluateTurbulence);
    evaluate(constants, {x, y, z}, {vx, vy, vz});
}

} // namespace fumage
#endif
