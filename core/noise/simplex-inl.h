// Included once per SIMD target: the lattice of simplices (tetrahedra) in three dimensions, and curl noise on it.

#if defined(FUMAGE_SIMPLEX_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_SIMPLEX_INL_H
#undef FUMAGE_SIMPLEX_INL_H
#else
#define FUMAGE_SIMPLEX_INL_H
#endif

#include "core/base/math-inl.h"
#include "core/noise/curl_slices.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// The four corners of the tetrahedron around a point, in an order that walks its edges.
/// Lattice: u = y+z, v = x+z, w = x+y, whole numbers at lattice points (body-centred cubic; neighbours sqrt(3)/2 apart).
/// Source: Perlin 2001 (simplex noise); the skew that keeps whole-number translations is that of Gustavson's psrdnoise.
template <class D>
struct SimplexCorners {
    hn::VFromD<D> dx[4]; ///< from corner to point
    hn::VFromD<D> dy[4];
    hn::VFromD<D> dz[4];
    hn::VFromD<hn::RebindToUnsigned<D>> lattice[4]; ///< a linear hash of (u, v, w); mix before use
};

template <class D, class V = hn::VFromD<D>>
HWY_INLINE SimplexCorners<D> simplexCorners(D d, V x, V y, V z)
{
    const hn::RebindToSigned<D> di;
    const hn::RebindToUnsigned<D> du;
    const V u = hn::Add(y, z);
    const V v = hn::Add(x, z);
    const V w = hn::Add(x, y);
    const V iu = hn::Floor(u);
    const V iv = hn::Floor(v);
    const V iw = hn::Floor(w);
    const V fu = hn::Sub(u, iu);
    const V fv = hn::Sub(v, iv);
    const V fw = hn::Sub(w, iw);

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
    const V half = hn::Set(d, 0.5F);
    const V one = hn::Set(d, 1.0F);
    const V sum = hn::Mul(half, hn::Add(hn::Add(fu, fv), fw));
    out.dx[0] = hn::Sub(sum, fu);
    out.dy[0] = hn::Sub(sum, fv);
    out.dz[0] = hn::Sub(sum, fw);
    out.dx[3] = hn::Sub(out.dx[0], half);
    out.dy[3] = hn::Sub(out.dy[0], half);
    out.dz[3] = hn::Sub(out.dz[0], half);
    out.dx[1] = hn::Add(out.dx[3], hn::IfThenElseZero(largeU, one));
    out.dy[1] = hn::Add(out.dy[3], hn::IfThenElseZero(largeV, one));
    out.dz[1] = hn::Add(out.dz[3], hn::IfThenElseZero(largeW, one));
    out.dx[2] = hn::Sub(out.dx[0], hn::IfThenElseZero(smallU, one));
    out.dy[2] = hn::Sub(out.dy[0], hn::IfThenElseZero(smallV, one));
    out.dz[2] = hn::Sub(out.dz[0], hn::IfThenElseZero(smallW, one));

    const auto pu = hn::Set(du, kLatticeU);
    const auto pv = hn::Set(du, kLatticeV);
    const auto pw = hn::Set(du, kLatticeW);
    const auto choose = [&](auto isU, auto isV) {
        const auto bitsU = hn::MaskFromVec(hn::BitCast(du, hn::VecFromMask(d, isU)));
        const auto bitsV = hn::MaskFromVec(hn::BitCast(du, hn::VecFromMask(d, isV)));
        return hn::IfThenElse(bitsU, pu, hn::IfThenElse(bitsV, pv, pw));
    };
    const auto cell = [&](V i) { return hn::BitCast(du, hn::ConvertTo(di, i)); };
    out.lattice[0] = hn::Add(hn::Add(hn::Mul(cell(iu), pu), hn::Mul(cell(iv), pv)), hn::Mul(cell(iw), pw));
    out.lattice[3] = hn::Add(out.lattice[0], hn::Set(du, kLatticeU + kLatticeV + kLatticeW));
    out.lattice[1] = hn::Add(out.lattice[0], choose(largeU, largeV));
    out.lattice[2] = hn::Sub(out.lattice[3], choose(smallU, smallV));
    return out;
}

/// Random bits of a lattice point; all 32 are usable.
template <class DU, class VU = hn::VFromD<DU>>
HWY_INLINE VU latticeBits(DU du, VU lattice, VU key)
{
    VU bits = hn::Xor(lattice, key);
    bits = hn::Mul(hn::Xor(bits, hn::ShiftRight<15>(bits)), hn::Set(du, 0x2c1b3c6dU));
    bits = hn::Mul(hn::Xor(bits, hn::ShiftRight<12>(bits)), hn::Set(du, 0x297a2d39U));
    return hn::Xor(bits, hn::ShiftRight<15>(bits));
}

/// A vector field at a vector of points.
template <class V>
struct FieldAt {
    V x, y, z;
};

/// Adds the curl noise at a point to the velocity, which is without divergence, exactly; and with kTurns what it turns, to the vorticity: the
/// curl of that velocity, per unit of the coordinates.
///
/// The potential is Psi = sum over corners of t^4 (c x d), with t = max(0, 1/2 - |d|^2), d the way from corner to point and c a random
/// vector of the corner, uniform in a cube. Its curl is 2 t^3 ((t - 4 |d|^2) c + 4 (d.c) d): each lattice point is a small vortex.
/// The curl of the velocity is 8 t^2 (5 t - 6 |d|^2) (c x d). All are linear in c, so that two sets cost little more than one.
/// Source: Bridson, Houriham, Nordenstam, "Curl-Noise for Procedural Fluid Flow", SIGGRAPH 2007, on simplex kernels.
template <bool kTurns, std::size_t kSlices, class D, class V = hn::VFromD<D>>
HWY_INLINE void addCurlNoise(D d, V x, V y, V z, const CurlSlices& slices, FieldAt<V>& velocity, FieldAt<V>& vorticity)
{
    const hn::RebindToSigned<D> di;
    const hn::RebindToUnsigned<D> du;
    const SimplexCorners<D> corners = simplexCorners(d, x, y, z);
    const V four = hn::Set(d, 4.0F);
    for (int i = 0; i < 4; ++i) {
        FieldAt<V> c;
        for (std::size_t slice = 0; slice < kSlices; ++slice) {
            const auto bits = latticeBits(du, hn::Add(corners.lattice[i], hn::Set(du, slices.shift[slice])), hn::Set(du, slices.key[slice]));
            const V weight = hn::Set(d, slices.weight[slice]);
            // Three components from one word: each starts at its own bit; what follows below is noise far under its step.
            const V cx = hn::Mul(weight, hn::ConvertTo(d, hn::BitCast(di, bits)));
            const V cy = hn::Mul(weight, hn::ConvertTo(d, hn::BitCast(di, hn::ShiftLeft<11>(bits))));
            const V cz = hn::Mul(weight, hn::ConvertTo(d, hn::BitCast(di, hn::ShiftLeft<22>(bits))));
            c = slice == 0 ? FieldAt<V>{cx, cy, cz} : FieldAt<V>{hn::Add(c.x, cx), hn::Add(c.y, cy), hn::Add(c.z, cz)};
        }
        const V dx = corners.dx[i];
        const V dy = corners.dy[i];
        const V dz = corners.dz[i];
        const V r2 = hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(dz, dz));
        const V t = hn::Max(hn::Zero(d), hn::Sub(hn::Set(d, 0.5F), r2));
        const V t3 = hn::Mul(hn::Mul(t, t), t);
        const V dot = hn::Add(hn::Add(hn::Mul(dx, c.x), hn::Mul(dy, c.y)), hn::Mul(dz, c.z));
        const V along = hn::Mul(t3, hn::Sub(t, hn::Mul(four, r2)));
        const V outward = hn::Mul(t3, hn::Mul(four, dot));
        velocity.x = hn::Add(velocity.x, hn::Add(hn::Mul(along, c.x), hn::Mul(outward, dx)));
        velocity.y = hn::Add(velocity.y, hn::Add(hn::Mul(along, c.y), hn::Mul(outward, dy)));
        velocity.z = hn::Add(velocity.z, hn::Add(hn::Mul(along, c.z), hn::Mul(outward, dz)));
        if constexpr (kTurns) {
            const V factor = hn::Mul(hn::Mul(t, t), hn::Sub(hn::Mul(hn::Set(d, 20.0F), t), hn::Mul(hn::Set(d, 24.0F), r2)));
            vorticity.x = mulAdd(factor, hn::Sub(hn::Mul(c.y, dz), hn::Mul(c.z, dy)), vorticity.x);
            vorticity.y = mulAdd(factor, hn::Sub(hn::Mul(c.z, dx), hn::Mul(c.x, dz)), vorticity.y);
            vorticity.z = mulAdd(factor, hn::Sub(hn::Mul(c.x, dy), hn::Mul(c.y, dx)), vorticity.z);
        }
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
