// Included once per SIMD target: makes the sum of two noises even again.

#if defined(FUMAGE_PHASE_BLEND_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_PHASE_BLEND_INL_H
#undef FUMAGE_PHASE_BLEND_INL_H
#else
#define FUMAGE_PHASE_BLEND_INL_H
#endif

#include "core/base/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

template <SimdVector V>
struct EvenNoise {
    V value;
    V grows; ///< with the sum
};

/// The vector form of PhaseBlend.
/// @param blend with its numbers
template <SimdVector V, class Blend>
HWY_INLINE EvenNoise<V> evened(const Blend& blend, V sum)
{
    const V size = hn::Abs(sum);
    const V beyond = hn::Max(everyLane<V>(0.0F), size - blend.flat);
    return {
        hn::CopySign(size * blend.gain - beyond * beyond * blend.bend, sum), blend.gain - beyond * (2.0F * blend.bend)};
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
