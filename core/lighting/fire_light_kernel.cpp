#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lighting/fire_light_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/lighting/fire_light_kernel.h"
#include "core/lighting/glow-inl.h"
#include "core/lighting/grid_cell-inl.h"
#include "core/simulation/ages-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

float fireOfChunk(const FireJob& job, const Particles& particles, const Appearance& appearance, const LightGrid& light,
    std::size_t chunk, FireWorkspace::Layer& out)
{
    const hn::ScalableTag<float> d;
    using V = hn::VFromD<decltype(d)>;
    const hn::RebindToSigned<decltype(d)> di;
    V largest = hn::Zero(d);
    const std::size_t begin = chunk * Particles::kChunk;
    for (std::size_t i = begin; i < begin + Particles::kChunk; i += hn::Lanes(d)) {
        const V radius = hn::Load(d, appearance.radius.data() + i);
        const V alpha = hn::Load(d, appearance.alpha.data() + i);
        const auto key = hn::Load(hn::RebindToUnsigned<decltype(d)>(), particles.key.data() + i);
        const V age = agesInSteps(d, particles, i, key, job.step, job.bornBetweenSteps) * job.dt;
        const V heat = glowingHeat(d, job.glow, particles, i, key, age);
        const auto corner = gridCellAt(d, light.shape, load(d, particles.x, particles.y, particles.z, i)).corner;
        const auto channels = hn::ShiftLeft<2>(corner);
        const V sky = hn::GatherIndex(d, light.light.data() + 1, channels);
        const V open = hn::Min(hn::Set(d, 1.0F), sky + hn::GatherIndex(d, light.light.data() + 2, channels));
        const V seen = clamp01(d, heat * (1.0F - job.hotCore * open));
        const V brightness =
            hn::GatherIndex(d, job.brightness.data(), hn::ConvertTo(di, seen * static_cast<float>(kGlowTableSize - 1)));
        // Clear flames give off what opaque ones would.
        V given = alpha / opaqueShare(d, job.glow, heat) * brightness * job.strength;
        if (!appearance.left.empty()) {
            given = given * hn::Load(d, appearance.left.data() + i);
        }
        largest = hn::Max(largest, given * (radius * radius));
        hn::Store(radius, d, out.glowing.radius.data() + i);
        hn::Store(given, d, out.glowing.alpha.data() + i);
        hn::Store(seen, d, out.heat.data() + i);
    }
    return hn::GetLane(hn::MaxOfLanes(d, largest));
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(fireOfChunk);

float findFireOfChunk(const FireJob& job, const Frame& frame, const Appearance& appearance, const LightGrid& light,
    std::size_t chunk, FireWorkspace::Layer& out)
{
    return HWY_DYNAMIC_DISPATCH(fireOfChunk)(job, frame.particles, appearance, light, chunk, out);
}

} // namespace fumage
#endif
