// Included once per SIMD target: half floats, with the same bits on every machine.

#if defined(FUMAGE_HALFS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_HALFS_INL_H
#undef FUMAGE_HALFS_INL_H
#else
#define FUMAGE_HALFS_INL_H
#endif

#include "core/base/lanes-inl.h"

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// The nearest number that a half float holds, of magnitude below 65504: converting it afterwards is exact on every
/// machine, however that rounds. Less than the least normal half is 0.
template <SimdVector V>
HWY_INLINE V roundedToHalf(V value)
{
    const hn::DFromV<V> d;
    const hn::RebindToUnsigned<hn::DFromV<V>> du;
    const auto bits = hn::BitCast(du, value);
    constexpr std::uint32_t kDropped = 0x1fff;
    const auto even = hn::ShiftRight<13>(bits) & 1U;
    const auto rounded = hn::AndNot(hn::Set(du, kDropped), bits + even + (kDropped >> 1U));
    return hn::IfThenElseZero(hn::Ge(hn::Abs(value), hn::Set(d, 0x1p-14F)), hn::BitCast(d, rounded));
}

/// Rounds and stores.
template <SimdVector V>
HWY_INLINE void storeHalf(V value, std::uint16_t* to)
{
    const hn::Rebind<hwy::float16_t, hn::DFromV<V>> half;
    hn::StoreU(
        hn::DemoteTo(half, roundedToHalf(value)), half, reinterpret_cast<hwy::float16_t*>(to)); // NOLINT: the same bits
}

template <class D>
HWY_INLINE hn::VFromD<D> loadHalf(D d, const std::uint16_t* from)
{
    const hn::Rebind<hwy::float16_t, D> half;
    return hn::PromoteTo(d, hn::LoadU(half, reinterpret_cast<const hwy::float16_t*>(from))); // NOLINT: the same bits
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
