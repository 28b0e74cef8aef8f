// Included once per SIMD target: the lattice of simplices (tetrahedra) in three dimensions, and curl noise on it.

#if defined(FUMAGE_SIMPLEX_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_SIMPLEX_INL_H
#undef FUMAGE_SIMPLEX_INL_H
#else
#define FUMAGE_SIMPLEX_INL_H
#endif

#include "core/base/hash-inl.h"
#include "core/base/vector-inl.h"
#include "core/noise/curl_slices.h"
#include "core/noise/lattice_hash.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// The four corners of the tetrahedron around a point, in an order that walks its edges.
/// Lattice: u = y+z, v = x+z, w = x+y, whole numbers at lattice points (body-centred cubic; neighbours sqrt(3)/2
/// apart). Source: Perlin 2001 (simplex noise); the skew that keeps whole-number translations is that of Gustavson's
/// psrdnoise.
template <class D>
struct SimplexCorners {
    Vec3<hn::VFromD<D>> way[4]; ///< from corner to point
    hn::VFromD<hn::RebindToUnsigned<D>> lattice[4]; ///< a linear hash of (u, v, w); mix before use
};

/// Whole numbers of magnitude below 2^22 as integers, by two instructions where a conversion that saturates takes five.
/// Beyond, where noise has no fractions to go by any more, they are wrong, but the same bits on every machine.
template <class D>
HWY_INLINE hn::VFromD<hn::RebindToUnsigned<D>> wholeBits(D d, hn::VFromD<D> whole)
{
    const hn::RebindToUnsigned<D> du;
    constexpr float kUnitIsLastBit = 0x1.8p23F;
    const auto first = hn::BitCast(du, hn::Set(d, kUnitIsLastBit));
    return hn::BitCast(du, whole + kUnitIsLastBit) - first;
}

template <class D, class V = hn::VFromD<D>>
HWY_INLINE SimplexCorners<D> simplexCorners(D d, const Vec3<V>& point)
{
    const hn::RebindToUnsigned<D> du;
    const V u = point.y + point.z;
    const V v = point.x + point.z;
    const V w = point.x + point.y;
    const V iu = hn::Floor(u);
    const V iv = hn::Floor(v);
    const V iw = hn::Floor(w);
    const V fu = u - iu;
    const V fv = v - iv;
    const V fw = w - iw;

    // Exactly one coordinate is the largest and one the smallest, ties included.
    const auto uv = hn::Ge(fu, fv);
    const auto uw = hn::Ge(fu, fw);
    const auto vw = hn::Ge(fv, fw);
    const auto largeU = hn::And(uv, uw);
    const auto largeV = hn::AndNot(uv, vw);
    const auto smallU = hn::Not(hn::Or(uv, uw));
    const auto smallW = hn::And(uw, vw);
    const auto largeW = hn::Not(hn::Or(largeU, largeV));
    const auto smallV = hn::Not(hn::Or(smallU, smallW));

    SimplexCorners<D> out;
    const V one = hn::Set(d, 1.0F);
    const auto oneWhere = [&](auto isU, auto isV, auto isW) HWY_ATTR {
        return Vec3<V>{hn::IfThenElseZero(isU, one), hn::IfThenElseZero(isV, one), hn::IfThenElseZero(isW, one)};
    };
    const V sum = 0.5F * (fu + fv + fw);
    out.way[0] = {sum - fu, sum - fv, sum - fw};
    out.way[3] = out.way[0] - glm::vec3(0.5F);
    out.way[1] = out.way[3] + oneWhere(largeU, largeV, largeW);
    out.way[2] = out.way[0] - oneWhere(smallU, smallV, smallW);

    const auto pu = hn::Set(du, kLatticeU);
    const auto pv = hn::Set(du, kLatticeV);
    const auto pw = hn::Set(du, kLatticeW);
    const auto choose = [&](auto isU, auto isV) HWY_ATTR {
        return hn::IfThenElse(hn::RebindMask(du, isU), pu, hn::IfThenElse(hn::RebindMask(du, isV), pv, pw));
    };
    const auto cell = [&](V i) HWY_ATTR { return wholeBits(d, i); };
    out.lattice[0] = cell(iu) * pu + cell(iv) * pv + cell(iw) * pw;
    out.lattice[3] = out.lattice[0] + (kLatticeU + kLatticeV + kLatticeW);
    out.lattice[1] = out.lattice[0] + choose(largeU, largeV);
    out.lattice[2] = out.lattice[3] - choose(smallU, smallV);
    return out;
}

/// The vector form of mixLattice().
template <SimdVector VU>
HWY_INLINE VU latticeBits(VU lattice, VU key)
{
    VU bits = lattice ^ key;
    bits = (bits ^ hn::ShiftRight<15>(bits)) * kLatticeFactor1;
    bits = (bits ^ hn::ShiftRight<12>(bits)) * kLatticeFactor2;
    return bits ^ hn::ShiftRight<15>(bits);
}

/// Three components from one word: each starts at its own bit; what follows below is noise far under its step.
template <class D, SimdVector VU>
HWY_INLINE Vec3<hn::VFromD<D>> signedComponents(D d, VU bits)
{
    return {signedValue(d, bits), signedValue(d, hn::ShiftLeft<11>(bits)), signedValue(d, hn::ShiftLeft<22>(bits))};
}

/// What curl noise is at a point.
template <SimdVector V>
struct Swirl {
    Vec3<V> velocity; ///< without divergence, exactly
    Vec3<V> vorticity; ///< its curl, per unit of the coordinates; where it is asked for
    Vec3<V> potential; ///< whose curl it is; where it is asked for
};

/// Adds the curl noise at a point.
///
/// The potential is Psi = sum over corners of t^4 (c x d), with t = max(0, 1/2 - |d|^2), d the way from corner to point
/// and c a random vector of the corner, uniform in a cube. Its curl is 2 t^3 ((t - 4 |d|^2) c + 4 (d.c) d): each
/// lattice point is a small vortex. (Half of both is added, and the rest is in the normalisation.) The curl of the
/// velocity is 8 t^2 (5 t - 6 |d|^2) (c x d). All are linear in c, so that two sets cost little more than one. Source:
/// Bridson, Houriham, Nordenstam, "Curl-Noise for Procedural Fluid Flow", SIGGRAPH 2007, on simplex kernels.
template <bool kTurns, bool kPotential, std::size_t kSlices, class D, class V = hn::VFromD<D>>
HWY_INLINE void addVortex(D d, const Vec3<V>& point, const CurlSlices& slices, Swirl<V>& swirl)
{
    const hn::RebindToUnsigned<D> du;
    const SimplexCorners<D> corners = simplexCorners(d, point);
    for (int i = 0; i < 4; ++i) {
        Vec3<V> c;
        for (std::size_t slice = 0; slice < kSlices; ++slice) {
            const auto bits = latticeBits(corners.lattice[i] + slices.shift[slice], hn::Set(du, slices.key[slice]));
            const Vec3<V> weighted = signedComponents(d, bits) * slices.weight[slice];
            c = slice == 0 ? weighted : c + weighted;
        }
        const Vec3<V>& way = corners.way[i];
        const V r2 = dot(way, way);
        const V t = hn::Max(hn::Zero(d), 0.5F - r2);
        const V t3 = t * t * t;
        swirl.velocity = swirl.velocity + (t3 * (t - 4.0F * r2) * c + t3 * (4.0F * dot(way, c)) * way);
        if constexpr (kTurns) {
            swirl.vorticity = swirl.vorticity + t * t * (20.0F * t - 24.0F * r2) * cross(c, way);
        }
        if constexpr (kPotential) {
            swirl.potential = swirl.potential + 0.5F * (t3 * t) * cross(c, way);
        }
    }
}

/// The same without its potential.
template <bool kTurns, std::size_t kSlices, class D, class V = hn::VFromD<D>>
HWY_INLINE void addCurlNoise(D d, const Vec3<V>& point, const CurlSlices& slices, Vec3<V>& velocity, Vec3<V>& vorticity)
{
    Swirl<V> swirl{velocity, vorticity, uniform(hn::Zero(d))};
    addVortex<kTurns, false, kSlices>(d, point, slices, swirl);
    velocity = swirl.velocity;
    vorticity = swirl.vorticity;
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
