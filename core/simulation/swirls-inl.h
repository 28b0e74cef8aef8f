// Included once per SIMD target: the moving air that carries particles. Turbulence, a train of vortex rings and a
// vortex.

#if defined(FUMAGE_SWIRLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_SWIRLS_INL_H
#undef FUMAGE_SWIRLS_INL_H
#else
#define FUMAGE_SWIRLS_INL_H
#endif

#include "core/base/hash-inl.h"
#include "core/base/math-inl.h"
#include "core/noise/simplex-inl.h"
#include "core/simulation/simulation_model.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Adds the noise of an octave, of one set of random vectors or two.
template <bool kTurns, bool kPotential, class D, class V = hn::VFromD<D>>
HWY_INLINE void addOctave(D d, const Vec3<V>& place, const CurlSlices& slices, Swirl<V>& swirl)
{
    if (slices.weight[1] != 0.0F) {
        addVortex<kTurns, kPotential, 2>(d, place, slices, swirl);
    } else {
        addVortex<kTurns, kPotential, 1>(d, place, slices, swirl);
    }
}

/// The sum of all octaves at a place, in units of the first.
template <bool kTurns, bool kPotential, class D, class V = hn::VFromD<D>>
HWY_INLINE Swirl<V> sumOfOctaves(D d, const StepConstants& constants, const Vec3<V>& q)
{
    const Vec3<V> none = uniform(hn::Zero(d));
    Swirl<V> sum{none, none, none};
    for (int octave = 0; octave < constants.octaves; ++octave) {
        const OctaveAtStep& at = constants.octave[static_cast<std::size_t>(octave)];
        const Vec3<V> place = q * at.frequency + at.shift;
        Swirl<V> here{sum.velocity, none, none};
        if (kTurns && at.turns) {
            addOctave<true, kPotential>(d, place, at.slices, here);
            sum.vorticity = sum.vorticity + here.vorticity * at.frequency;
        } else {
            addOctave<false, kPotential>(d, place, at.slices, here);
        }
        sum.velocity = here.velocity;
        if constexpr (kPotential) {
            sum.potential = sum.potential + here.potential * (1.0F / at.frequency);
        }
    }
    return sum;
}

/// Adds the turbulence at a position to the velocity, and with kTurns the vorticity of its larger swirls in 1/s.
///
/// Swirls may grow with the height h over the pivot: with w = 1 + g h, q = (x / w, ln(w) / g, z / w) / scale, in which
/// all of them have one size. The flow is the curl of w^2 scale^2 J^T Psi(q), J the derivatives of q and V the curl of
/// Psi: V + (g / w) Vy (x, 0, z) + 2 g scale (Psi_z, 0, -Psi_x). So it has no divergence, whatever the growth, it keeps
/// its speed upwards, and it spreads as the swirls do. (The vorticity is that of V alone.)
template <bool kTurns, class D, class V = hn::VFromD<D>>
HWY_INLINE void addTurbulence(
    D d, const StepConstants& constants, const Vec3<V>& position, V ramp, Vec3<V>& velocity, Vec3<V>& vorticity)
{
    const float frequency = constants.turbulenceFrequency;
    const Vec3<V> away = position - constants.pivot;
    if (constants.growth == 0.0F) {
        const Swirl<V> sum = sumOfOctaves<kTurns, false>(d, constants, away * frequency);
        velocity = velocity + sum.velocity * ramp;
        if constexpr (kTurns) {
            vorticity = vorticity + sum.vorticity * (ramp * frequency);
        }
        return;
    }
    const V above = hn::Max(away.y, hn::Zero(d));
    const V shrink = 1.0F / (constants.growth * above + 1.0F);
    const V logHeight = logarithm(d, constants.growth * above + 1.0F) * (1.0F / constants.growth);
    const Vec3<V> q{
        away.x * frequency * shrink, (logHeight + (away.y - above)) * frequency, away.z * frequency * shrink};
    Swirl<V> sum = sumOfOctaves<kTurns, true>(d, constants, q);
    // below the pivot nothing grows
    const V growth = hn::IfThenElseZero(hn::Gt(away.y, hn::Zero(d)), hn::Set(d, constants.growth));
    const V spread = growth * shrink * sum.velocity.y;
    const V twist = growth * (2.0F / frequency);
    sum.velocity.x = sum.velocity.x + (spread * away.x + twist * sum.potential.z);
    sum.velocity.z = sum.velocity.z + (spread * away.z - twist * sum.potential.x);
    velocity = velocity + sum.velocity * ramp;
    if constexpr (kTurns) {
        vorticity = vorticity + sum.vorticity * (ramp * shrink * frequency);
    }
}

/// Three numbers in [0, 1), fixed for each number of a ring: what its strength loses, and where its axis lies to two
/// sides.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE Vec3<V> ringDraws(D d, V number, std::uint32_t key)
{
    const hn::RebindToUnsigned<D> du;
    const hn::RebindToSigned<D> di;
    const auto bits = mixedBits(hn::BitCast(du, hn::ConvertTo(di, number)) ^ key);
    constexpr std::uint32_t kTenBits = 1023;
    const auto unit = [&](auto tenBits) HWY_ATTR { return signedValue(d, tenBits) * 0x1p-10F; };
    return {unit(hn::ShiftRight<22>(bits)), unit(hn::ShiftRight<12>(bits) & kTenBits),
        unit(hn::ShiftRight<2>(bits) & kTenBits)};
}

/// The strength of a ring of some number; where ring 0 is the first, the air before it is still.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE V ringStrength(D d, const StepConstants& constants, V number, V draw)
{
    const V zero = hn::Zero(d);
    const V strength = constants.ringStrength * (1.0F - constants.ringVariance * draw);
    const V followers = hn::Set(d, constants.ringFollowers);
    if (!constants.ringsLead) {
        return strength * followers;
    }
    const V own = hn::IfThenElse(hn::Gt(number, zero), followers, hn::Set(d, 1.0F));
    return hn::IfThenElseZero(hn::Ge(number, zero), strength * own);
}

/// Adds the flow of a train of vortex rings on an axis through the pivot, and with kTurns its vorticity in 1/s.
///
/// With r the way from a ring's axis, rho its length, s = rho / R, r0 the way from the common axis, h the height along
/// it, z that above the ring, L the spacing and t = (z + b r0^2) / L with b = 1 / (2 R), so that rings arch as domes,
/// the potential is A = S/2 q^4 C (axis x r), q = max(0, 1 - s^2 / 5), C = (1 - 4 t^2)^2. Its curl is S q^3 (q - 4/5
/// s^2) C - (r.r0 / R) v along the axis and v r with v = 8 S/L q^4 t (1 - 4 t^2): through the middle, out above, down
/// outside and in below. Where R grows by k a metre and axes lie o R aside, v r has (1 - k r0^2 / (2 R^2)) times that
/// and less by S q^3 C 4/5 k (r.r0) / R^3, and k/2 S q^4 C o is added: it has no divergence wherever rings lie and
/// however they grow. Half-way to the next ring C is 0 and flat, so that each may have its own strength and axis, and
/// the air before the first can be still. The vorticity is that of rings that do not arch. Polynomials stand in for the
/// Gauss and cosine shapes of measured rings, at a third of their cost.
template <bool kTurns, class D, class V = hn::VFromD<D>>
HWY_INLINE void addRings(
    D d, const StepConstants& constants, const Vec3<V>& position, Vec3<V>& velocity, Vec3<V>& vorticity)
{
    const V zero = hn::Zero(d);
    const Vec3<V> axis = broadcast(d, constants.ringAxis);
    Vec3<V> away = position - constants.pivot;
    const V height = dot(away, axis);
    away = away - height * axis;
    const V radius = constants.ringWidening * hn::Max(height, zero) + constants.ringRadius;
    const V perRadius = 1.0F / radius;

    // Which ring this is follows from the common axis, so that all of a ring agree about it.
    const V arch = 0.5F * perRadius;
    const V rings = (arch * dot(away, away) + height - constants.ringCentre) * constants.ringsPerMetre;
    const V nearest = hn::Round(rings);
    const V t = rings - nearest;
    V number = constants.ringNumber - nearest;
    if (constants.ringsInLoop > 0.0F) {
        const V laps = hn::Floor((number + 0.5F) * (1.0F / constants.ringsInLoop));
        number = number - laps * constants.ringsInLoop;
    }
    const Vec3<V> draws = ringDraws(d, number, constants.ringKey);
    const V strength = ringStrength(d, constants, number, draws.x);
    const V reach = constants.ringVariance * radius;
    const Vec3<V> common = away;
    away = away - (reach * (draws.y - 0.5F)) * constants.ringSides[0];
    away = away - (reach * (draws.z - 0.5F)) * constants.ringSides[1];

    const V rho2 = dot(away, away);
    const V s2 = rho2 * (perRadius * perRadius);
    const V q = hn::Max(zero, 1.0F - 0.2F * s2);
    const V q2 = q * q;
    const V outside = q - 0.8F * s2;
    const V slope = 1.0F - 4.0F * (t * t);
    const V crest = slope * slope;
    const V core = strength * (q2 * q);
    const V outward = core * q * (8.0F * constants.ringsPerMetre * (t * slope)); // per metre from the axis
    const V between = dot(common, away);
    const V along = core * outside * crest - perRadius * between * outward;
    velocity = velocity + (outward * away + along * axis);
    if (constants.ringWidening > 0.0F) {
        const V widening = hn::IfThenElseZero(hn::Gt(height, zero), hn::Set(d, constants.ringWidening));
        const V inward = perRadius
            * (0.5F * perRadius * dot(common, common) * outward
                + 0.8F * (perRadius * perRadius) * between * (core * crest));
        const Vec3<V> aside = perRadius * (common - away);
        velocity = velocity + widening * (0.5F * (core * q * crest) * aside - inward * away);
    }
    if constexpr (kTurns) {
        const float perSpacing2 = constants.ringsPerMetre * constants.ringsPerMetre;
        const V bend = perSpacing2 * (8.0F - 96.0F * (t * t));
        const V shear = 2.0F * (perRadius * perRadius) * (0.6F * outside + q);
        vorticity = vorticity + strength * q2 * (q2 * bend + shear * crest) * cross(axis, away);
    }
}

/// Where a vortex about an axis through the pivot takes a position in one step or a part of it: speed = strength * 2 s
/// / (1 + s^2), s = distance / radius, which may widen along the axis (Scully 1975). Turned exactly, by the angle at
/// that distance; a straight step along the tangent would lead outwards in a spiral.
/// @param time see WholeStep
template <class D, class Time, class V = hn::VFromD<D>>
HWY_INLINE Vec3<V> turnedByVortex(D d, const StepConstants& constants, const Time& time, const Vec3<V>& position)
{
    const Vec3<V> axis = broadcast(d, constants.vortexAxis);
    const Vec3<V> away = position - constants.pivot;
    const Vec3<V> tangent = cross(axis, away); // as long as the distance from the axis
    const Vec3<V> outward = cross(tangent, axis);
    const V radius = constants.vortexWidening * hn::Max(dot(away, axis), hn::Zero(d)) + constants.vortexRadius;
    const V halfAngle = constants.vortexStrength * radius * constants.dt / (radius * radius + dot(tangent, tangent));
    const SineCosine<V> half = sinCos(d, time(halfAngle));
    return position + 2.0F * half.sine * (half.cosine * tangent - half.sine * outward);
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
