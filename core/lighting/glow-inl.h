// Included once per SIMD target: how hot particles still are to the eye.

#if defined(FUMAGE_GLOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_GLOW_INL_H
#undef FUMAGE_GLOW_INL_H
#else
#define FUMAGE_GLOW_INL_H
#endif

#include "core/base/hash-inl.h"
#include "core/base/math-inl.h"
#include "core/lighting/glow.h"
#include "core/simulation/particles.h"
#include "core/simulation/streams.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Heat that glows, as a share of that at birth, of particle i and those after it.
/// @param age s
template <class D, SimdVector VU, class V = hn::VFromD<D>>
HWY_INLINE V glowingHeat(D d, const GlowTable& glow, const Particles& particles, std::size_t i, VU key, V age)
{
    const V heat = 1.0F - glow.heatVariance * unitStream(d, key, kHeatStream);
    const V cooled = heat * exponential(d, -glow.cooling * age);
    return particles.inAir() ? cooled * hn::Load(d, particles.heat.data() + i) : cooled;
}

/// Share of its opacity that smoke has while it glows.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE V opaqueShare(D d, const GlowTable& glow, V heat)
{
    const hn::RebindToSigned<D> di;
    return hn::GatherIndex(
        d, glow.opaque.data(), hn::ConvertTo(di, clamp01(d, heat) * static_cast<float>(kGlowTableSize - 1)));
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
