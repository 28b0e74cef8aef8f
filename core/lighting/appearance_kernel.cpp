#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lighting/appearance_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/hash-inl.h"
#include "core/base/math-inl.h"
#include "core/lighting/appearance_kernel.h"
#include "core/lighting/glow-inl.h"
#include "core/lighting/grid_cell-inl.h"
#include "core/simulation/ages-inl.h"
#include "core/simulation/streams.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;

/// Bounds that grow lane by lane.
struct LaneBounds {
    Vec3<V> low;
    Vec3<V> high;

    template <class M>
    HWY_INLINE void add(const Vec3<V>& place, M where)
    {
        const auto extend = [&](V at, V& lowest, V& highest) HWY_ATTR {
            lowest = hn::Min(lowest, hn::IfThenElse(where, at, everyLane<V>(std::numeric_limits<float>::max())));
            highest = hn::Max(highest, hn::IfThenElse(where, at, everyLane<V>(std::numeric_limits<float>::lowest())));
        };
        extend(place.x, low.x, high.x);
        extend(place.y, low.y, high.y);
        extend(place.z, low.z, high.z);
    }

    [[nodiscard]] HWY_INLINE Bounds ofAll(D d) const
    {
        const auto least = [&](V v) HWY_ATTR { return hn::GetLane(hn::MinOfLanes(d, v)); };
        const auto most = [&](V v) HWY_ATTR { return hn::GetLane(hn::MaxOfLanes(d, v)); };
        return {{least(low.x), least(low.y), least(low.z)}, {most(high.x), most(high.y), most(high.z)}};
    }
};

ChunkExtent appearanceOfChunk(const AppearanceJob& job, const Particles& particles, std::size_t chunk, Appearance& out)
{
    const D d;
    const hn::RebindToSigned<D> di;
    const hn::RebindToUnsigned<D> du;
    const V one = hn::Set(d, 1.0F);
    const V zero = hn::Zero(d);
    const Bounds nothing;
    LaneBounds bounds{broadcast(d, nothing.low), broadcast(d, nothing.high)};
    V largestMass = zero;
    V largestRadius = zero;
    V lost = zero; // not a number where a particle is nowhere: bounds do not show it, since minima pass over it
    std::size_t count = 0;
    const std::size_t begin = chunk * Particles::kChunk;
    for (std::size_t i = begin; i < begin + Particles::kChunk; i += hn::Lanes(d)) {
        const auto key = hn::Load(du, particles.key.data() + i);
        const V age = agesInSteps(d, particles, i, key, job.step, job.bornBetweenSteps);
        const V lifetime = job.lifetimeSteps * (1.0F - job.lifetimeVariance * unitStream(d, key, kLifetimeStream));
        const auto alive = hn::And(hn::Lt(age, lifetime), hn::Ge(age, zero));
        const V life = hn::IfThenElseZero(alive, age / lifetime);
        const V fading = job.fadeRate * (job.lifetimeSteps / lifetime);
        const V faded = hn::Max(zero, job.initialAlpha - fading * (age * job.dt));
        const auto entry = hn::ConvertTo(di, life * static_cast<float>(kLifeTableSize - 1));
        V dense = faded * hn::GatherIndex(d, job.alpha.data(), entry);
        if (job.heatOpacity > 0.0F) {
            dense = dense * (1.0F - job.heatOpacity * (1.0F - hn::Min(one, hn::Load(d, particles.heat.data() + i))));
        }
        V alpha = hn::Min(one, dense);
        if (job.groundFade > 0.0F) {
            alpha = alpha
                * smoothStep(
                    clamp01(d, (hn::Load(d, particles.y.data() + i) - job.ground) / hn::Set(d, job.groundFade)));
        }
        if (job.glow.clears) {
            alpha = alpha * opaqueShare(d, job.glow, glowingHeat(d, job.glow, particles, i, key, age * job.dt));
        }
        const V varied = 1.0F - job.sizeVariance * unitStream(d, key, kSizeStream);
        const V radius = job.radius * hn::GatherIndex(d, job.size.data(), entry) * varied;
        const auto visible = hn::And(alive, hn::Gt(alpha, zero));
        V mass = alpha * (radius * radius);
        if (out.cover.erodes) {
            const V left = hn::GatherIndex(
                d, out.cover.left.data(), hn::ConvertTo(di, life * static_cast<float>(Coverage::kLives) + 0.5F));
            mass = mass * left;
            hn::Store(left, d, out.left.data() + i);
        }
        largestMass = hn::Max(largestMass, hn::IfThenElseZero(visible, mass));
        largestRadius = hn::Max(largestRadius, hn::IfThenElseZero(visible, radius));
        hn::Store(hn::IfThenElseZero(visible, radius), d, out.radius.data() + i);
        hn::Store(hn::IfThenElseZero(visible, alpha), d, out.alpha.data() + i);
        hn::Store(life, d, out.life.data() + i);
        count += hn::CountTrue(d, visible);
        const Vec3<V> place = inAxes(job.axes, load(d, particles.x, particles.y, particles.z, i));
        bounds.add(place, visible);
        lost = lost + hn::IfThenElseZero(visible, (place.x + place.y + place.z) * zero);
    }
    Bounds all = bounds.ofAll(d);
    if (!hn::AllTrue(d, hn::Eq(lost, zero))) {
        all.high = glm::vec3(std::numeric_limits<float>::infinity());
    }
    return {all, hn::GetLane(hn::MaxOfLanes(d, largestMass)), hn::GetLane(hn::MaxOfLanes(d, largestRadius)), count};
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(appearanceOfChunk);

ChunkExtent findAppearanceOfChunk(
    const AppearanceJob& job, const Particles& particles, std::size_t chunk, Appearance& out)
{
    return HWY_DYNAMIC_DISPATCH(appearanceOfChunk)(job, particles, chunk, out);
}

} // namespace fumage
#endif
