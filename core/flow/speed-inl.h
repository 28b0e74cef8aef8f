// Included once per SIMD target: how fast air may be.

#if defined(FUMAGE_SPEED_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_SPEED_INL_H
#undef FUMAGE_SPEED_INL_H
#else
#define FUMAGE_SPEED_INL_H
#endif

#include "core/base/vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Fastest that the air may be in each component, m/s: a forced flow without end, or a source that blows up faster than
/// air can leave, would else end in infinity, and then in no number. Half floats hold it.
inline constexpr float kMaxAirSpeed = 2000.0F;

/// @param speed of one component, m/s
template <class D>
HWY_INLINE hn::VFromD<D> boundedSpeed(D d, hn::VFromD<D> speed)
{
    const auto most = hn::Set(d, kMaxAirSpeed);
    return hn::Min(hn::Max(speed, hn::Neg(most)), most);
}

template <class D>
HWY_INLINE Vec3<hn::VFromD<D>> boundedSpeed(D d, const Vec3<hn::VFromD<D>>& v)
{
    return {boundedSpeed(d, v.x), boundedSpeed(d, v.y), boundedSpeed(d, v.z)};
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
