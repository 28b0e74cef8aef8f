// Included once per SIMD target: how the detail of a sprite changes its alpha.

#if defined(FUMAGE_DETAIL_ALPHA_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_DETAIL_ALPHA_INL_H
#undef FUMAGE_DETAIL_ALPHA_INL_H
#else
#define FUMAGE_DETAIL_ALPHA_INL_H
#endif

#include "core/base/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Of a sprite in detail.
constexpr float kMaxAlpha = 0.995F;

/// A factor on alpha for even noise t, with y = 1 + strength t: 0 below y = -1/2, a parabola up to 1/2, y above.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE V alphaFactor(D d, V even, float strength)
{
    const V bent = even * strength + 1.5F;
    const V low = clamp01(d, bent);
    return low * low * 0.5F + hn::Max(hn::Zero(d), bent - 1.0F);
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
