// Included once per SIMD target: how old particles are.

#if defined(FUMAGE_AGES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_AGES_INL_H
#undef FUMAGE_AGES_INL_H
#else
#define FUMAGE_AGES_INL_H
#endif

#include "core/base/hash-inl.h"
#include "core/simulation/particles.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Ages at a step of particle i and those after it, in steps, as lifecycle() has them: a particle that is born between
/// two steps has lived for a part of one when it first appears, which is its key as a random number: streams are hashes
/// of the key and independent of it.
/// @param key of the particles
template <class D, SimdVector VU>
HWY_INLINE hn::VFromD<D> agesInSteps(
    D d, const Particles& particles, std::size_t i, VU key, std::int32_t step, bool betweenSteps)
{
    const hn::RebindToSigned<D> di;
    const auto age = hn::ConvertTo(d, step - hn::Load(di, particles.birthStep.data() + i));
    return betweenSteps ? age + unitFloat(d, key) : age;
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
