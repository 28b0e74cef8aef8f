#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/simulation/step_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/math-inl.h"
#include "core/base/math.h"
#include "core/noise/simplex-inl.h"
#include "core/simulation/step.h"
#include "core/simulation/streams.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;

using Triple = FieldAt<V>;

/// Three independent random int32 as float, for one particle and step: three rounds of multiply and shift over key XOR step key.
template <class VU>
HWY_INLINE Triple signedDraws(D d, VU key, VU stepKey)
{
    const hn::RebindToUnsigned<D> du;
    const hn::RebindToSigned<D> di;
    VU bits = hn::Mul(hn::Xor(key, stepKey), hn::Set(du, 0x7feb352dU));
    bits = hn::Mul(hn::Xor(bits, hn::ShiftRight<15>(bits)), hn::Set(du, 0x846ca68bU));
    bits = hn::Xor(bits, hn::ShiftRight<16>(bits));
    Triple out;
    out.x = hn::ConvertTo(d, hn::BitCast(di, bits));
    bits = hn::Mul(bits, hn::Set(du, 0x9e3779b1U));
    bits = hn::Xor(bits, hn::ShiftRight<15>(bits));
    out.y = hn::ConvertTo(d, hn::BitCast(di, bits));
    bits = hn::Mul(bits, hn::Set(du, 0x85ebca77U));
    bits = hn::Xor(bits, hn::ShiftRight<16>(bits));
    out.z = hn::ConvertTo(d, hn::BitCast(di, bits));
    return out;
}

/// Eq. III to V and IX to XII alone. Kept apart from the whole model so that its loop is short enough to pipeline.
void stepPlain(const StepConstants& constants, Particles& particles, std::size_t chunk)
{
    const D d;
    const hn::RebindToUnsigned<D> du;
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
    const auto stepKey = hn::Set(du, constants.key);
    const Triple steady{hn::Set(d, constants.steady.x), hn::Set(d, constants.steady.y), hn::Set(d, constants.steady.z)};
    const Triple random{hn::Set(d, constants.random.x), hn::Set(d, constants.random.y), hn::Set(d, constants.random.z)};
    for (std::size_t i = begin; i < end; i += hn::Lanes(d)) {
        const Triple draw = signedDraws(d, hn::Load(du, key + i), stepKey);
        const V newVx = hn::Add(hn::Load(d, vx + i), mulAdd(random.x, draw.x, steady.x));
        const V newVy = hn::Add(hn::Load(d, vy + i), mulAdd(random.y, draw.y, steady.y));
        const V newVz = hn::Add(hn::Load(d, vz + i), mulAdd(random.z, draw.z, steady.z));
        hn::Store(newVx, d, vx + i);
        hn::Store(newVy, d, vy + i);
        hn::Store(newVz, d, vz + i);
        hn::Store(mulAdd(newVx, dt, hn::Load(d, x + i)), d, x + i);
        hn::Store(mulAdd(newVy, dt, hn::Load(d, y + i)), d, y + i);
        hn::Store(mulAdd(newVz, dt, hn::Load(d, z + i)), d, z + i);
    }
}

/// Adds the turbulence at a position to the velocity, and with kTurns the vorticity of its larger swirls in 1/s. Coordinates shrink with
/// height so that swirls grow: q = (x, ln(1 + g h) / g, z) / (scale (1 + g h)) in x and z, whose spacing in y is also scale (1 + g h).
template <bool kTurns>
HWY_INLINE void addTurbulence(D d, const StepConstants& constants, const Triple& position, V ramp, Triple& velocity, Triple& vorticity)
{
    const V frequency = hn::Set(d, constants.turbulenceFrequency);
    const V height = hn::Sub(position.y, hn::Set(d, constants.pivot.y));
    Triple q{hn::Mul(hn::Sub(position.x, hn::Set(d, constants.pivot.x)), frequency), hn::Mul(height, frequency),
        hn::Mul(hn::Sub(position.z, hn::Set(d, constants.pivot.z)), frequency)};
    V shrunk = ramp;
    if (constants.growth > 0.0F) {
        const V one = hn::Set(d, 1.0F);
        const V above = hn::Max(height, hn::Zero(d));
        const V widening = mulAdd(hn::Set(d, constants.growth), above, one);
        const V logHeight = hn::Mul(logarithm(d, widening), hn::Set(d, 1.0F / constants.growth));
        const V shrink = hn::Div(one, widening);
        shrunk = hn::Mul(ramp, shrink);
        q.x = hn::Mul(q.x, shrink);
        q.z = hn::Mul(q.z, shrink);
        q.y = hn::Mul(hn::Add(logHeight, hn::Sub(height, above)), frequency);
    }
    Triple sum{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    Triple turn = sum;
    for (int octave = 0; octave < constants.octaves; ++octave) {
        const OctaveAtStep& at = constants.octave[static_cast<std::size_t>(octave)];
        const V scale = hn::Set(d, at.frequency);
        const Triple place{hn::Mul(q.x, scale), mulAdd(q.y, scale, hn::Set(d, at.offset)), hn::Mul(q.z, scale)};
        const auto add = [&](auto turns, Triple& turned) HWY_ATTR {
            if (at.slices.weight[1] != 0.0F) {
                addCurlNoise<turns.value, 2>(d, place.x, place.y, place.z, at.slices, sum, turned);
            } else {
                addCurlNoise<turns.value, 1>(d, place.x, place.y, place.z, at.slices, sum, turned);
            }
        };
        Triple turned{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
        if (kTurns && at.turns) {
            add(std::true_type(), turned);
            turn = {mulAdd(turned.x, scale, turn.x), mulAdd(turned.y, scale, turn.y), mulAdd(turned.z, scale, turn.z)};
        } else {
            add(std::false_type(), turned);
        }
    }
    velocity.x = mulAdd(sum.x, ramp, velocity.x);
    velocity.y = mulAdd(sum.y, ramp, velocity.y);
    velocity.z = mulAdd(sum.z, ramp, velocity.z);
    if constexpr (kTurns) {
        const V perMetre = hn::Mul(shrunk, frequency);
        vorticity = {mulAdd(turn.x, perMetre, vorticity.x), mulAdd(turn.y, perMetre, vorticity.y), mulAdd(turn.z, perMetre, vorticity.z)};
    }
}

/// Adds the flow of a train of vortex rings on an axis through the pivot, and with kTurns its vorticity in 1/s.
///
/// With rho the distance from a ring's axis, s = rho / R, z the way along the axis from its centre, L the spacing and t = (z + b rho^2) / L with
/// b = 1 / (2 R), so that rings arch as domes, the potential is A = S/2 rho q^4 C about the axis, q = max(0, 1 - s^2 / 5), C = (1 - 4 t^2)^2.
/// Its curl is S q^3 (q - 4/5 s^2) C - 2 b rho v along the axis and v = 8 S/L rho q^4 t (1 - 4 t^2) away from it: through the middle, out
/// above, down outside and in below, with no divergence where R is constant and the ring on the axis. Half-way to the next ring C is 0 and
/// flat, so that each may have its own strength and axis, and the air before the first can be still. The vorticity is that of rings that do
/// not arch. Polynomials stand in for the Gauss and cosine shapes of measured rings, at a third of their cost.
template <bool kTurns>
HWY_INLINE void addRings(D d, const StepConstants& constants, const Triple& position, Triple& velocity, Triple& vorticity)
{
    const hn::RebindToUnsigned<D> du;
    const hn::RebindToSigned<D> di;
    const V one = hn::Set(d, 1.0F);
    const V zero = hn::Zero(d);
    const Triple axis{hn::Set(d, constants.ringAxis.x), hn::Set(d, constants.ringAxis.y), hn::Set(d, constants.ringAxis.z)};
    Triple away{hn::Sub(position.x, hn::Set(d, constants.pivot.x)), hn::Sub(position.y, hn::Set(d, constants.pivot.y)), hn::Sub(position.z, hn::Set(d, constants.pivot.z))};
    const V height = mulAdd(away.z, axis.z, mulAdd(away.y, axis.y, hn::Mul(away.x, axis.x)));
    away = {hn::Sub(away.x, hn::Mul(height, axis.x)), hn::Sub(away.y, hn::Mul(height, axis.y)), hn::Sub(away.z, hn::Mul(height, axis.z))};
    const V radius = mulAdd(hn::Set(d, constants.ringWidening), hn::Max(height, zero), hn::Set(d, constants.ringRadius));
    const V perRadius = hn::Div(one, radius);
    const auto distance2 = [](const Triple& t) HWY_ATTR { return mulAdd(t.z, t.z, mulAdd(t.y, t.y, hn::Mul(t.x, t.x))); };

    // Which ring this is follows from the common axis, so that all of a ring agree about it.
    const V arch = hn::Mul(hn::Set(d, 0.5F), perRadius);
    const V way = hn::Sub(mulAdd(arch, distance2(away), height), hn::Set(d, constants.ringCentre));
    const V rings = hn::Mul(way, hn::Set(d, constants.ringsPerMetre));
    const V nearest = hn::Round(rings);
    const V t = hn::Sub(rings, nearest);
    V number = hn::Sub(hn::Set(d, constants.ringNumber), nearest);
    if (constants.ringsInLoop > 0.0F) {
        const V laps = hn::Floor(hn::Mul(hn::Add(number, hn::Set(d, 0.5F)), hn::Set(d, 1.0F / constants.ringsInLoop)));
        number = hn::Sub(number, hn::Mul(laps, hn::Set(d, constants.ringsInLoop)));
    }
    // Three numbers in [0, 1) from one word.
    const auto bits = mixBitsV(du, hn::Xor(hn::BitCast(du, hn::ConvertTo(di, number)), hn::Set(du, constants.ringKey)));
    const auto unit = [&](auto part) HWY_ATTR { return hn::Mul(hn::ConvertTo(d, hn::BitCast(di, part)), hn::Set(d, 0x1p-10F)); };
    const auto tenBits = hn::Set(du, 1023U);
    const V draws[3] = {unit(hn::ShiftRight<22>(bits)), unit(hn::And(hn::ShiftRight<12>(bits), tenBits)), unit(hn::And(hn::ShiftRight<2>(bits), tenBits))};
    const V variance = hn::Set(d, constants.ringVariance);
    V strength = hn::Mul(hn::Set(d, constants.ringStrength), hn::Sub(one, hn::Mul(variance, draws[0])));
    const V followers = hn::Set(d, constants.ringFollowers);
    if (constants.ringsLead) {
        const V own = hn::IfThenElse(hn::Gt(number, zero), followers, one);
        strength = hn::IfThenElseZero(hn::Ge(number, zero), hn::Mul(strength, own));
    } else {
        strength = hn::Mul(strength, followers);
    }
    const V reach = hn::Mul(variance, radius);
    for (std::size_t side = 0; side < 2; ++side) {
        const glm::vec3& along = constants.ringSides[side];
        const V shift = hn::Mul(reach, hn::Sub(draws[side + 1], hn::Set(d, 0.5F)));
        away = {hn::Sub(away.x, hn::Mul(shift, hn::Set(d, along.x))), hn::Sub(away.y, hn::Mul(shift, hn::Set(d, along.y))), hn::Sub(away.z, hn::Mul(shift, hn::Set(d, along.z)))};
    }

    const V rho2 = distance2(away);
    const V s2 = hn::Mul(rho2, hn::Mul(perRadius, perRadius));
    const V q = hn::Max(zero, mulAdd(hn::Set(d, -0.2F), s2, one));
    const V q2 = hn::Mul(q, q);
    const V outside = mulAdd(hn::Set(d, -0.8F), s2, q);
    const V slope = mulAdd(hn::Set(d, -4.0F), hn::Mul(t, t), one);
    const V crest = hn::Mul(slope, slope);
    const V core = hn::Mul(strength, hn::Mul(q2, q));
    const V outward = hn::Mul(hn::Mul(core, q), hn::Mul(hn::Set(d, 8.0F * constants.ringsPerMetre), hn::Mul(t, slope))); // per metre from the axis
    const V along = hn::Sub(hn::Mul(hn::Mul(core, outside), crest), hn::Mul(hn::Mul(perRadius, rho2), outward));
    const auto component = [&](V from, V alongAxis, V awayFrom) HWY_ATTR { return hn::Add(from, mulAdd(outward, awayFrom, hn::Mul(along, alongAxis))); };
    velocity = {component(velocity.x, axis.x, away.x), component(velocity.y, axis.y, away.y), component(velocity.z, axis.z, away.z)};
    if constexpr (kTurns) {
        const float perSpacing2 = constants.ringsPerMetre * constants.ringsPerMetre;
        const V bend = hn::Mul(hn::Set(d, perSpacing2), mulAdd(hn::Set(d, -96.0F), hn::Mul(t, t), hn::Set(d, 8.0F)));
        const V shear = hn::Mul(hn::Mul(hn::Set(d, 2.0F), hn::Mul(perRadius, perRadius)), mulAdd(hn::Set(d, 0.6F), outside, q));
        const V about = hn::Mul(hn::Mul(strength, q2), mulAdd(q2, bend, hn::Mul(shear, crest)));
        vorticity.x = mulAdd(about, hn::Sub(hn::Mul(axis.y, away.z), hn::Mul(axis.z, away.y)), vorticity.x);
        vorticity.y = mulAdd(about, hn::Sub(hn::Mul(axis.z, away.x), hn::Mul(axis.x, away.z)), vorticity.y);
        vorticity.z = mulAdd(about, hn::Sub(hn::Mul(axis.x, away.y), hn::Mul(axis.y, away.x)), vorticity.z);
    }
}

/// Adds a vortex about an axis through the pivot: speed = strength * 2 s / (1 + s^2), s = distance / radius (Scully 1975).
HWY_INLINE void addVortex(D d, const StepConstants& constants, const Triple& position, Triple& velocity)
{
    const V ax = hn::Set(d, constants.vortexAxis.x);
    const V ay = hn::Set(d, constants.vortexAxis.y);
    const V az = hn::Set(d, constants.vortexAxis.z);
    const V px = hn::Sub(position.x, hn::Set(d, constants.pivot.x));
    const V py = hn::Sub(position.y, hn::Set(d, constants.pivot.y));
    const V pz = hn::Sub(position.z, hn::Set(d, constants.pivot.z));
    // axis x (from the pivot): tangential, and as long as the distance from the axis
    const V tx = hn::Sub(hn::Mul(ay, pz), hn::Mul(az, py));
    const V ty = hn::Sub(hn::Mul(az, px), hn::Mul(ax, pz));
    const V tz = hn::Sub(hn::Mul(ax, py), hn::Mul(ay, px));
    const V distance2 = hn::Add(hn::Add(hn::Mul(tx, tx), hn::Mul(ty, ty)), hn::Mul(tz, tz));
    const float radius = constants.vortexRadius;
    const V factor = hn::Div(hn::Set(d, 2.0F * constants.vortexStrength * radius), hn::Add(hn::Set(d, radius * radius), distance2));
    velocity.x = mulAdd(tx, factor, velocity.x);
    velocity.y = mulAdd(ty, factor, velocity.y);
    velocity.z = mulAdd(tz, factor, velocity.z);
}

/// 0 at birth to 1 at the onset, smooth at both ends.
HWY_INLINE V onsetRamp(D d, const StepConstants& constants, V age)
{
    if (constants.onset <= 0.0F) {
        return hn::Set(d, 1.0F);
    }
    const V t = clamp01(d, hn::Mul(age, hn::Set(d, 1.0F / constants.onset)));
    return hn::Mul(hn::Mul(t, t), mulAdd(hn::Set(d, -2.0F), t, hn::Set(d, 3.0F)));
}

template <bool kTurns>
HWY_INLINE void stepWholeWith(const StepConstants& constants, Particles& particles, std::size_t chunk)
{
    const D d;
    const hn::RebindToUnsigned<D> du;
    const hn::RebindToSigned<D> di;
    const std::size_t begin = chunk * Particles::kChunk;
    const std::size_t end = begin + Particles::kChunk;
    const V dt = hn::Set(d, constants.dt);
    const V one = hn::Set(d, 1.0F);
    const bool rotates = constants.rotationSin != 0.0F;
    for (std::size_t i = begin; i < end; i += hn::Lanes(d)) {
        const auto key = hn::Load(du, particles.key.data() + i);
        const V age = hn::Mul(hn::ConvertTo(d, hn::Sub(hn::Set(di, constants.step), hn::Load(di, particles.birthStep.data() + i))), dt);
        Triple p{hn::Load(d, particles.x.data() + i), hn::Load(d, particles.y.data() + i), hn::Load(d, particles.z.data() + i)};
        Triple v{hn::Load(d, particles.vx.data() + i), hn::Load(d, particles.vy.data() + i), hn::Load(d, particles.vz.data() + i)};

        // Buoyancy and the pull towards the axis, with the same randomness as wind and gravity.
        const V heat = mulAdd(hn::Set(d, -constants.heatVariance), unitStream(d, key, kHeatStream), one);
        const V cooled = exponential(d, hn::Mul(hn::Set(d, -constants.cooling), age));
        const Triple own{hn::Mul(hn::Set(d, -constants.pull), hn::Sub(p.x, hn::Set(d, constants.pivot.x))),
            hn::Mul(hn::Mul(hn::Set(d, constants.buoyancy), heat), cooled),
            hn::Mul(hn::Set(d, -constants.pull), hn::Sub(p.z, hn::Set(d, constants.pivot.z)))};
        const Triple draw = signedDraws(d, key, hn::Set(du, constants.key));
        const V calm = hn::Set(d, 1.0F - constants.randomness);
        const V wild = hn::Set(d, constants.randomness * 0x1p-31F);
        const V drag = hn::Set(d, constants.dragFactor);
        const auto accelerate = [&](V velocity, V ownPart, V drawn, float steady, float random) {
            const V common = mulAdd(hn::Set(d, random), drawn, hn::Set(d, steady));
            return hn::Mul(hn::Add(hn::Add(velocity, common), hn::Mul(ownPart, mulAdd(wild, drawn, calm))), drag);
        };
        v.x = accelerate(v.x, own.x, draw.x, constants.steady.x, constants.random.x);
        v.y = accelerate(v.y, own.y, draw.y, constants.steady.y, constants.random.y);
        v.z = accelerate(v.z, own.z, draw.z, constants.steady.z, constants.random.z);

        Triple carried = v;
        Triple vorticity{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
        if (constants.octaves > 0) {
            addTurbulence<kTurns>(d, constants, p, onsetRamp(d, constants, age), carried, vorticity);
        }
        if (constants.ringStrength != 0.0F) {
            addRings<kTurns>(d, constants, p, carried, vorticity);
        }
        if (constants.vortexStrength != 0.0F) {
            addVortex(d, constants, p, carried);
        }
        if constexpr (kTurns) {
            // A small body in a flow turns at half its vorticity.
            const V halfStep = hn::Set(d, 0.5F * constants.dt);
            const auto turn = [&](AlignedArray<float>& column, V rate) HWY_ATTR { hn::Store(mulAdd(rate, halfStep, hn::Load(d, column.data() + i)), d, column.data() + i); };
            turn(particles.rollX, vorticity.x);
            turn(particles.rollY, vorticity.y);
            turn(particles.rollZ, vorticity.z);
        }
        p = {mulAdd(carried.x, dt, p.x), mulAdd(carried.y, dt, p.y), mulAdd(carried.z, dt, p.z)};

        if (rotates) {
            const V s = hn::Set(d, constants.rotationSin);
            const V c = hn::Set(d, constants.rotationCos);
            const V rx = hn::Sub(p.x, hn::Set(d, constants.pivot.x));
            const V rz = hn::Sub(p.z, hn::Set(d, constants.pivot.z));
            p.x = hn::Add(hn::Add(hn::Mul(c, rx), hn::Mul(s, rz)), hn::Set(d, constants.pivot.x));
            p.z = hn::Add(hn::Sub(hn::Mul(c, rz), hn::Mul(s, rx)), hn::Set(d, constants.pivot.z));
            const V turnedX = hn::Add(hn::Mul(c, v.x), hn::Mul(s, v.z));
            v.z = hn::Sub(hn::Mul(c, v.z), hn::Mul(s, v.x));
            v.x = turnedX;
        }
        hn::Store(p.x, d, particles.x.data() + i);
        hn::Store(p.y, d, particles.y.data() + i);
        hn::Store(p.z, d, particles.z.data() + i);
        hn::Store(v.x, d, particles.vx.data() + i);
        hn::Store(v.y, d, particles.vy.data() + i);
        hn::Store(v.z, d, particles.vz.data() + i);
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

void evaluateTurbulence(const StepConstants& constants, const float* x, const float* y, const float* z, float* vx, float* vy, float* vz, std::size_t count)
{
    const D d;
    const std::size_t lanes = hn::Lanes(d);
    HWY_ALIGN float buffer[6][HWY_MAX_BYTES / sizeof(float)] = {};
    for (std::size_t i = 0; i < count; i += lanes) {
        const std::size_t n = HWY_MIN(lanes, count - i);
        for (std::size_t lane = 0; lane < n; ++lane) {
            buffer[0][lane] = x[i + lane];
            buffer[1][lane] = y[i + lane];
            buffer[2][lane] = z[i + lane];
        }
        Triple sum{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
        Triple none = sum;
        addTurbulence<false>(d, constants, {hn::Load(d, buffer[0]), hn::Load(d, buffer[1]), hn::Load(d, buffer[2])}, hn::Set(d, 1.0F), sum, none);
        hn::Store(sum.x, d, buffer[3]);
        hn::Store(sum.y, d, buffer[4]);
        hn::Store(sum.z, d, buffer[5]);
        for (std::size_t lane = 0; lane < n; ++lane) {
            vx[i + lane] = buffer[3][lane];
            vy[i + lane] = buffer[4][lane];
            vz[i + lane] = buffer[5][lane];
        }
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(stepPlain);
HWY_EXPORT(stepWhole);
HWY_EXPORT(evaluateTurbulence);

void stepChunk(const StepConstants& constants, Particles& particles, std::size_t chunk)
{
    if (constants.plain) {
        HWY_DYNAMIC_DISPATCH(stepPlain)
        (constants, particles, chunk);
    } else {
        HWY_DYNAMIC_DISPATCH(stepWhole)
        (constants, particles, chunk);
    }
}

void turbulenceAt(const StepConstants& constants, std::span<const float> x, std::span<const float> y, std::span<const float> z,
    std::span<float> vx, std::span<float> vy, std::span<float> vz)
{
    HWY_DYNAMIC_DISPATCH(evaluateTurbulence)
    (constants, x.data(), y.data(), z.data(), vx.data(), vy.data(), vz.data(), x.size());
}

} // namespace fumage
#endif
