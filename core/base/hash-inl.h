// Included once per SIMD target: the random bits of hash.h, a vector of them at a time.

#if defined(FUMAGE_HASH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_HASH_INL_H
#undef FUMAGE_HASH_INL_H
#else
#define FUMAGE_HASH_INL_H
#endif

#include "core/base/hash.h"
#include "core/base/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// The vector form of mixBits().
template <SimdVector VU>
HWY_INLINE VU mixedBits(VU x)
{
    x = (x ^ hn::ShiftRight<16>(x)) * kMixFactor1;
    x = (x ^ hn::ShiftRight<15>(x)) * kMixFactor2;
    return x ^ hn::ShiftRight<16>(x);
}

/// The vector form of keyOf(), of indices by their lower and upper halves.
template <SimdVector VU>
HWY_INLINE VU keysOf(std::uint32_t seed, VU low, VU high)
{
    return mixedBits(mixedBits(low + seed * kGoldenStep) ^ (high * kUpperHalfFactor + seed));
}

/// Whole numbers as floats of their value, as signed ones.
template <class D, SimdVector VU>
HWY_INLINE hn::VFromD<D> signedValue(D d, VU bits)
{
    return hn::ConvertTo(d, hn::BitCast(hn::RebindToSigned<D>(), bits));
}

/// The vector form of unitFloat(bits).
template <class D, SimdVector VU>
HWY_INLINE hn::VFromD<D> unitFloat(D d, VU bits)
{
    return signedValue(d, hn::ShiftRight<8>(bits)) * 0x1p-24F;
}

/// That of unitFloat(streamBits(key, stream)).
template <class D, SimdVector VU>
HWY_INLINE hn::VFromD<D> unitStream(D d, VU key, std::uint32_t stream)
{
    return unitFloat(d, mixedBits(key + (stream + 1U) * kGoldenStep));
}

/// The same in [-1, 1).
template <class D, SimdVector VU>
HWY_INLINE hn::VFromD<D> signedStream(D d, VU key, std::uint32_t stream)
{
    return 2.0F * unitStream(d, key, stream) - 1.0F;
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
