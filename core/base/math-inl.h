// Included once per SIMD target: sine, cosine, exponential and logarithm from adds and multiplies alone, so that every
// machine and every vector width gives the same bits. The C library's differ from one version to the next.

#if defined(FUMAGE_MATH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_MATH_INL_H
#undef FUMAGE_MATH_INL_H
#else
#define FUMAGE_MATH_INL_H
#endif

#include "core/base/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// a * b + c with two roundings: never a fused instruction.
template <class V>
HWY_INLINE V mulAdd(V a, V b, V c)
{
    return hn::Add(hn::Mul(a, b), c);
}

template <class D>
HWY_INLINE hn::VFromD<D> clamp01(D d, hn::VFromD<D> x)
{
    return hn::Min(hn::Max(x, hn::Zero(d)), hn::Set(d, 1.0F));
}

/// From 0 to 1 with level ends, for t in [0, 1]: 3 t^2 - 2 t^3.
template <SimdVector V>
HWY_INLINE V smoothStep(V t)
{
    return t * t * (3.0F - 2.0F * t);
}

template <SimdVector V>
struct SineCosine {
    V sine, cosine;
};

/// Sine and cosine of x radians, |x| up to 8192: absolute error below 2e-7 plus that of the reduction.
/// Cody-Waite reduction by pi/2 in three parts, then minimax polynomials on [-pi/4, pi/4] (coefficients: Cephes,
/// Moshier).
template <class D, class V = hn::VFromD<D>>
HWY_INLINE SineCosine<V> sinCos(D d, V x)
{
    const hn::RebindToSigned<D> di;
    const V quarterTurns = hn::Round(x * 0.636619772F);
    V r = quarterTurns * -1.5703125F + x;
    r = quarterTurns * -4.837512969970703125e-4F + r;
    r = quarterTurns * -7.54978995489188216e-8F + r;
    const V r2 = r * r;

    V s = -1.9515295891e-4F * r2 + 8.3321608736e-3F;
    s = s * r2 + -1.6666654611e-1F;
    s = s * r2 * r + r;

    V c = 2.443315711809948e-5F * r2 + -1.388731625493765e-3F;
    c = c * r2 + 4.166664568298827e-2F;
    c = (-0.5F * r2 + c * (r2 * r2)) + 1.0F;

    const auto quadrant = hn::ConvertTo(di, quarterTurns);
    const auto swap = hn::MaskFromVec(hn::BitCast(d, hn::Neg(quadrant & 1)));
    const auto sineSign = hn::BitCast(d, hn::ShiftLeft<30>(quadrant & 2));
    const auto cosineSign = hn::BitCast(d, hn::ShiftLeft<30>((quadrant + 1) & 2));
    return {hn::IfThenElse(swap, c, s) ^ sineSign, hn::IfThenElse(swap, s, c) ^ cosineSign};
}

/// e^x; x is clamped to [-87, 88]. Relative error below 2e-7.
/// Reduction by ln 2 in two parts, polynomial of degree 6 (coefficients: Cephes, Moshier), scaling through the
/// exponent.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE V exponential(D d, V x)
{
    const hn::RebindToSigned<D> di;
    x = hn::Min(hn::Max(x, hn::Set(d, -87.0F)), hn::Set(d, 88.0F));
    const V n = hn::Round(x * 1.44269504088896341F);
    V r = n * -0.693359375F + x;
    r = n * 2.12194440e-4F + r;
    V p = 1.9875691500e-4F * r + 1.3981999507e-3F;
    p = p * r + 8.3334519073e-3F;
    p = p * r + 4.1665795894e-2F;
    p = p * r + 1.6666665459e-1F;
    p = p * r + 5.0000001201e-1F;
    p = (p * (r * r) + r) + 1.0F;
    const auto scale = hn::ShiftLeft<23>(hn::ConvertTo(di, n) + 127);
    return p * hn::BitCast(d, scale);
}

/// ln x for normal x > 0; anything smaller is taken as the smallest normal number. Absolute error below 2e-7 near 1,
/// relative elsewhere. Splits off the exponent, then a polynomial on [sqrt(1/2), sqrt(2)] (coefficients: Cephes,
/// Moshier).
template <class D, class V = hn::VFromD<D>>
HWY_INLINE V logarithm(D d, V x)
{
    const hn::RebindToSigned<D> di;
    x = hn::Max(x, hn::Set(d, 0x1p-126F));
    const auto bits = hn::BitCast(di, x);
    V e = hn::ConvertTo(d, hn::ShiftRight<23>(bits) - 126);
    V m = hn::BitCast(d, hn::Or(bits & 0x007fffff, hn::Set(di, 0x3f000000)));
    const auto low = hn::Lt(m, hn::Set(d, 0.707106781186547524F));
    e = e - hn::IfThenElseZero(low, hn::Set(d, 1.0F));
    m = (m + hn::IfThenElseZero(low, m)) - 1.0F;
    const V z = m * m;
    V p = 7.0376836292e-2F * m + -1.1514610310e-1F;
    p = p * m + 1.1676998740e-1F;
    p = p * m + -1.2420140846e-1F;
    p = p * m + 1.4249322787e-1F;
    p = p * m + -1.6668057665e-1F;
    p = p * m + 2.0000714765e-1F;
    p = p * m + -2.4999993993e-1F;
    p = p * m + 3.3333331174e-1F;
    p = p * m * z;
    p = e * -2.12194440e-4F + p;
    p = -0.5F * z + p;
    return e * 0.693359375F + (m + p);
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
