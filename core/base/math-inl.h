// Included once per SIMD target: sine, cosine, exponential and logarithm from adds and multiplies alone, so that every
// machine and every vector width gives the same bits. The C library's differ from one version to the next.

#if defined(FUMAGE_MATH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_MATH_INL_H
#undef FUMAGE_MATH_INL_H
#else
#define FUMAGE_MATH_INL_H
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

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

/// Sine and cosine of x radians, |x| up to 8192: absolute error below 2e-7 plus that of the reduction.
/// Cody-Waite reduction by pi/2 in three parts, then minimax polynomials on [-pi/4, pi/4] (coefficients: Cephes, Moshier).
template <class D, class V = hn::VFromD<D>>
HWY_INLINE void sinCos(D d, V x, V& sine, V& cosine)
{
    const hn::RebindToSigned<D> di;
    const V quarterTurns = hn::Round(hn::Mul(x, hn::Set(d, 0.636619772F)));
    V r = mulAdd(quarterTurns, hn::Set(d, -1.5703125F), x);
    r = mulAdd(quarterTurns, hn::Set(d, -4.837512969970703125e-4F), r);
    r = mulAdd(quarterTurns, hn::Set(d, -7.54978995489188216e-8F), r);
    const V r2 = hn::Mul(r, r);

    V s = mulAdd(hn::Set(d, -1.9515295891e-4F), r2, hn::Set(d, 8.3321608736e-3F));
    s = mulAdd(s, r2, hn::Set(d, -1.6666654611e-1F));
    s = mulAdd(hn::Mul(s, r2), r, r);

    V c = mulAdd(hn::Set(d, 2.443315711809948e-5F), r2, hn::Set(d, -1.388731625493765e-3F));
    c = mulAdd(c, r2, hn::Set(d, 4.166664568298827e-2F));
    c = hn::Add(mulAdd(hn::Set(d, -0.5F), r2, hn::Mul(c, hn::Mul(r2, r2))), hn::Set(d, 1.0F));

    const auto quadrant = hn::ConvertTo(di, quarterTurns);
    const auto one = hn::Set(di, 1);
    const auto two = hn::Set(di, 2);
    const auto swap = hn::MaskFromVec(hn::BitCast(d, hn::Neg(hn::And(quadrant, one))));
    const auto sineSign = hn::BitCast(d, hn::ShiftLeft<30>(hn::And(quadrant, two)));
    const auto cosineSign = hn::BitCast(d, hn::ShiftLeft<30>(hn::And(hn::Add(quadrant, one), two)));
    sine = hn::Xor(hn::IfThenElse(swap, c, s), sineSign);
    cosine = hn::Xor(hn::IfThenElse(swap, s, c), cosineSign);
}

/// e^x; x is clamped to [-87, 88]. Relative error below 2e-7.
/// Reduction by ln 2 in two parts, polynomial of degree 6 (coefficients: Cephes, Moshier), scaling through the exponent.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE V exponential(D d, V x)
{
    const hn::RebindToSigned<D> di;
    x = hn::Min(hn::Max(x, hn::Set(d, -87.0F)), hn::Set(d, 88.0F));
    const V n = hn::Round(hn::Mul(x, hn::Set(d, 1.44269504088896341F)));
    V r = mulAdd(n, hn::Set(d, -0.693359375F), x);
    r = mulAdd(n, hn::Set(d, 2.12194440e-4F), r);
    V p = mulAdd(hn::Set(d, 1.9875691500e-4F), r, hn::Set(d, 1.3981999507e-3F));
    p = mulAdd(p, r, hn::Set(d, 8.3334519073e-3F));
    p = mulAdd(p, r, hn::Set(d, 4.1665795894e-2F));
    p = mulAdd(p, r, hn::Set(d, 1.6666665459e-1F));
    p = mulAdd(p, r, hn::Set(d, 5.0000001201e-1F));
    p = hn::Add(mulAdd(p, hn::Mul(r, r), r), hn::Set(d, 1.0F));
    const auto scale = hn::ShiftLeft<23>(hn::Add(hn::ConvertTo(di, n), hn::Set(di, 127)));
    return hn::Mul(p, hn::BitCast(d, scale));
}

/// ln x for normal x > 0; anything smaller is taken as the smallest normal number. Absolute error below 2e-7 near 1,
/// relative elsewhere. Splits off the exponent, then a polynomial on [sqrt(1/2), sqrt(2)] (coefficients: Cephes, Moshier).
template <class D, class V = hn::VFromD<D>>
HWY_INLINE V logarithm(D d, V x)
{
    const hn::RebindToSigned<D> di;
    x = hn::Max(x, hn::Set(d, 0x1p-126F));
    const auto bits = hn::BitCast(di, x);
    auto e = hn::ConvertTo(d, hn::Sub(hn::ShiftRight<23>(bits), hn::Set(di, 126)));
    V m = hn::BitCast(d, hn::Or(hn::And(bits, hn::Set(di, 0x007fffff)), hn::Set(di, 0x3f000000)));
    const auto low = hn::Lt(m, hn::Set(d, 0.707106781186547524F));
    e = hn::Sub(e, hn::IfThenElseZero(low, hn::Set(d, 1.0F)));
    m = hn::Sub(hn::Add(m, hn::IfThenElseZero(low, m)), hn::Set(d, 1.0F));
    const V z = hn::Mul(m, m);
    V p = mulAdd(hn::Set(d, 7.0376836292e-2F), m, hn::Set(d, -1.1514610310e-1F));
    p = mulAdd(p, m, hn::Set(d, 1.1676998740e-1F));
    p = mulAdd(p, m, hn::Set(d, -1.2420140846e-1F));
    p = mulAdd(p, m, hn::Set(d, 1.4249322787e-1F));
    p = mulAdd(p, m, hn::Set(d, -1.6668057665e-1F));
    p = mulAdd(p, m, hn::Set(d, 2.0000714765e-1F));
    p = mulAdd(p, m, hn::Set(d, -2.4999993993e-1F));
    p = mulAdd(p, m, hn::Set(d, 3.3333331174e-1F));
    p = hn::Mul(hn::Mul(p, m), z);
    p = mulAdd(e, hn::Set(d, -2.12194440e-4F), p);
    p = mulAdd(hn::Set(d, -0.5F), z, p);
    return mulAdd(e, hn::Set(d, 0.693359375F), hn::Add(m, p));
}

/// The vector form of mixBits().
template <class D, class V = hn::VFromD<D>>
HWY_INLINE V mixBitsV(D d, V x)
{
    x = hn::Xor(x, hn::ShiftRight<16>(x));
    x = hn::Mul(x, hn::Set(d, 0x7feb352dU));
    x = hn::Xor(x, hn::ShiftRight<15>(x));
    x = hn::Mul(x, hn::Set(d, 0x846ca68bU));
    return hn::Xor(x, hn::ShiftRight<16>(x));
}

/// The vector form of unitFloat(streamBits(key, stream)).
template <class DF, class VU, class V = hn::VFromD<DF>>
HWY_INLINE V unitStream(DF df, VU key, std::uint32_t stream)
{
    const hn::RebindToUnsigned<DF> du;
    const hn::RebindToSigned<DF> di;
    const auto bits = mixBitsV(du, hn::Add(key, hn::Set(du, (stream + 1U) * 0x9e3779b9U)));
    return hn::Mul(hn::ConvertTo(df, hn::BitCast(di, hn::ShiftRight<8>(bits))), hn::Set(df, 0x1p-24F));
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
