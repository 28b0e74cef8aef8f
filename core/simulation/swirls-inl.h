// Included once per SIMD target: the moving air that carries particles. Turbulence, a train of vortex rings and a vortex.

#if defined(FUMAGE_SWIRLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_SWIRLS_INL_H
#undef FUMAGE_SWIRLS_INL_H
#else
#define FUMAGE_SWIRLS_INL_H
#endif

#include "core/base/hash-inl.h"
#include "core/base/math-inl.h"
#include "core/noise/simplex-inl.h"
#include "core/simulation/model.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Adds the noise of an octave, of one set of random vectors or two.
template <bool kTurns, class D, class V = hn::VFromD<D>>
HWY_INLINE void addOctave(D d, const Vec3<V>& place, const CurlSlices& slices, Vec3<V>& velocity, Vec3<V>& vorticity)
{
    if (slices.weight[1] != 0.0F) {
        addCurlNoise<kTurns, 2>(d, place, slices, velocity, vorticity);
    } else {
        addCurlNoise<kTurns, 1>(d, place, slices, velocity, vorticity);
    }
}

/// Adds the turbulence at a position to the velocity, and with kTurns the vorticity of its larger swirls in 1/s. Coordinates shrink with
/// height so that swirls grow: q = (x, ln(1 + g h) / g, z) / (scale (1 + g h)) in x and z, whose spacing in y is also scale (1 + g h).
/// Without growth the flow V has no divergence. With it, directions and speeds are not adapted to q (that would take the potential and its cost):
/// what is left is -g / (1 + g h) (x dVy/dx + z dVy/dz), root mean square sqrt(2 / 15) g rho / (1 + g h) of the gradient at rho from the axis.
template <bool kTurns, class D, class V = hn::VFromD<D>>
HWY_INLINE void addTurbulence(D d, const StepConstants& constants, const Vec3<V>& position, V ramp, Vec3<V>& velocity, Vec3<V>& vorticity)
{
    const float frequency = constants.turbulenceFrequency;
    const Vec3<V> away = position - constants.pivot;
    Vec3<V> q = away * frequency;
    V shrunk = ramp;
    if (constants.growth > 0.0F) {
        const V above = hn::Max(away.y, hn::Zero(d));
        const V widening = constants.growth * above + 1.0F;
        const V logHeight = logarithm(d, widening) * (1.0F / constants.growth);
        const V shrink = 1.0F / widening;
        shrunk = ramp * shrink;
        q = {q.x * shrink, (logHeight + (away.y - above)) * frequency, q.z * shrink};
    }
    Vec3<V> sum = uniform(hn::Zero(d));
    Vec3<V> turn = sum;
    for (int octave = 0; octave < constants.octaves; ++octave) {
        const OctaveAtStep& at = constants.octave[static_cast<std::size_t>(octave)];
        const Vec3<V> place = q * at.frequency + at.shift;
        Vec3<V> turned = uniform(hn::Zero(d));
        if (kTurns && at.turns) {
            addOctave<true>(d, place, at.slices, sum, turned);
            turn = turn + turned * at.frequency;
        } else {
            addOctave<false>(d, place, at.slices, sum, turned);
        }
    }
    velocity = velocity + sum * ramp;
    if constexpr (kTurns) {
        vorticity = vorticity + turn * (shrunk * frequency);
    }
}

/// Three numbers in [0, 1), fixed for each number of a ring: what its strength loses, and where its axis lies to two sides.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE Vec3<V> ringDraws(D d, V number, std::uint32_t key)
{
    const hn::RebindToUnsigned<D> du;
    const hn::RebindToSigned<D> di;
    const auto bits = mixedBits(hn::BitCast(du, hn::ConvertTo(di, number)) ^ key);
    constexpr std::uint32_t kTenBits = 1023;
    const auto unit = [&](auto tenBits) HWY_ATTR { return signedValue(d, tenBits) * 0x1p-10F; };
    return {unit(hn::ShiftRight<22>(bits)), unit(hn::ShiftRight<12>(bits) & kTenBits), unit(hn::ShiftRight<2>(bits) & kTenBits)};
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
/// With rho the distance from a ring's axis, s = rho / R, z the way along the axis from its centre, L the spacing and t = (z + b rho^2) / L with
/// b = 1 / (2 R), so that rings arch as domes, the potential is A = S/2 rho q^4 C about the axis, q = max(0, 1 - s^2 / 5), C = (1 - 4 t^2)^2.
/// Its curl is S q^3 (q - 4/5 s^2) C - 2 b rho v along the axis and v = 8 S/L rho q^4 t (1 - 4 t^2) away from it: through the middle, out
/// above, down outside and in below, with no divergence where R is constant and the ring on the axis; a widening of 0.3 makes it 9 % of the
/// gradient, root mean square, and a variance of 0.6 as much as 8 %, since where a ring lies then follows from another axis. Half-way to the next ring C is 0 and
/// flat, so that each may have its own strength and axis, and the air before the first can be still. The vorticity is that of rings that do
/// not arch. Polynomials stand in for the Gauss and cosine shapes of measured rings, at a third of their cost.
template <bool kTurns, class D, class V = hn::VFromD<D>>
HWY_INLINE void addRings(D d, const StepConstants& constants, const Vec3<V>& position, Vec3<V>& velocity, Vec3<V>& vorticity)
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
    const V along = core * outside * crest - perRadius * rho2 * outward;
    velocity = velocity + (outward * away + along * axis);
    if constexpr (kTurns) {
        const float perSpacing2 = constants.ringsPerMetre * constants.ringsPerMetre;
        const V bend = perSpacing2 * (8.0F - 96.0F * (t * t));
        const V shear = 2.0F * (perRadius * perRadius) * (0.6F * outside + q);
        vorticity = vorticity + strength * q2 * (q2 * bend + shear * crest) * cross(axis, away);
    }
}

/// Where a vortex about an axis through the pivot takes a position in one step or a part of it: speed = strength * 2 s / (1 + s^2), s = distance / radius, which may widen along the axis
/// (Scully 1975). Turned exactly, by the angle at that distance; a straight step along the tangent would lead outwards in a spiral.
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
