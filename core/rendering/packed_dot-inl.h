// Included once per SIMD target: bytes and halves packed in 32-bit lanes, and sums of their products, for which
// Highway 1.0.3 has no operation. Integers give the same bits whichever way they are added.

#if defined(FUMAGE_PACKED_DOT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_PACKED_DOT_INL_H
#undef FUMAGE_PACKED_DOT_INL_H
#else
#define FUMAGE_PACKED_DOT_INL_H
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The lowest byte of each lane in all four bytes of it.
template <class DI, class VI = hn::VFromD<DI>>
HWY_INLINE VI spreadLowestByte(DI di, VI x)
{
#if HWY_TARGET == HWY_SCALAR
    return hn::Mul(hn::And(x, hn::Set(di, 255)), hn::Set(di, 0x01010101));
#else
    const hn::Repartition<std::uint8_t, DI> bytes;
    const auto order = hn::BitCast(bytes, hn::Mul(hn::And(hn::Iota(di, 0), hn::Set(di, 3)), hn::Set(di, 0x04040404)));
    return hn::BitCast(di, hn::TableLookupBytes(hn::BitCast(bytes, x), order));
#endif
}

/// Two 16-bit sums in each lane: byte 0 of a (unsigned) times byte 0 of b (signed) plus bytes 1, then bytes 2 and 3.
/// The sums have to fit.
template <class DI, class VI = hn::VFromD<DI>>
HWY_INLINE VI dotBytes(DI di, VI a, VI b)
{
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
    (void)di;
    return VI{_mm512_maddubs_epi16(a.raw, b.raw)};
#elif HWY_TARGET == HWY_AVX2
    (void)di;
    return VI{_mm256_maddubs_epi16(a.raw, b.raw)};
#elif HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
    (void)di;
    return VI{_mm_maddubs_epi16(a.raw, b.raw)};
#else
    const auto low = hn::Set(di, 255);
    const auto product = [&](VI x, VI signedTop)
                             HWY_ATTR { return hn::Mul(hn::And(x, low), hn::ShiftRight<24>(signedTop)); };
    const VI first = hn::Add(product(a, hn::ShiftLeft<24>(b)), product(hn::ShiftRight<8>(a), hn::ShiftLeft<16>(b)));
    const VI second = hn::Add(product(hn::ShiftRight<16>(a), hn::ShiftLeft<8>(b)), product(hn::ShiftRight<24>(a), b));
    return hn::Or(hn::And(first, hn::Set(di, 0xffff)), hn::ShiftLeft<16>(second));
#endif
}

/// One sum in each lane: low 16 bits of a times low 16 bits of b, plus the high ones, all signed.
template <class DI, class VI = hn::VFromD<DI>>
HWY_INLINE VI dotHalves(DI di, VI a, VI b)
{
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
    (void)di;
    return VI{_mm512_madd_epi16(a.raw, b.raw)};
#elif HWY_TARGET == HWY_AVX2
    (void)di;
    return VI{_mm256_madd_epi16(a.raw, b.raw)};
#elif HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
    (void)di;
    return VI{_mm_madd_epi16(a.raw, b.raw)};
#else
    (void)di;
    const auto low = [](VI x) HWY_ATTR { return hn::ShiftRight<16>(hn::ShiftLeft<16>(x)); };
    return hn::Add(hn::Mul(low(a), low(b)), hn::Mul(hn::ShiftRight<16>(a), hn::ShiftRight<16>(b)));
#endif
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
