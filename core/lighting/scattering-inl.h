// Included once per SIMD target: how much of a light smoke scatters towards the eye.

#if defined(FUMAGE_SCATTERING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_SCATTERING_INL_H
#undef FUMAGE_SCATTERING_INL_H
#else
#define FUMAGE_SCATTERING_INL_H
#endif

#include "core/base/lanes-inl.h"
#include "core/base/math-inl.h"
#include "core/lighting/sun_job.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Henyey-Greenstein relative to isotropic scattering: (1 - g^2) / (1 + g^2 - 2 g cosine)^(3/2).
template <SimdVector V>
HWY_INLINE V phase(float g, V cosine)
{
    const V base = (1.0F + g * g) - 2.0F * g * cosine;
    return (1.0F - g * g) / (base * hn::Sqrt(base));
}

/// Light of three orders of scattering that has come through an optical depth.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE V scattered(D d, const SunJob& job, V tau, V cosine)
{
    constexpr float kDeeper = 0.35F; // extinction that each order of scattering still sees, relative to the one before
    V sum = hn::Zero(d);
    float weight = job.intensity / (1.0F + job.scattering + job.scattering * job.scattering);
    float reach = 1.0F;
    float g = job.anisotropy;
    for (int order = 0; order < 3; ++order) {
        sum = weight * phase(g, cosine) * exponential(d, tau * -reach) + sum;
        weight *= job.scattering;
        reach *= kDeeper;
        g *= 0.5F;
    }
    return sum;
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
