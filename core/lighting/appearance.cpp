#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lighting/appearance.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/hash-inl.h"
#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/lighting/appearance.h"
#include "core/simulation/streams.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#ifndef FUMAGE_APPEARANCE_ONCE
#define FUMAGE_APPEARANCE_ONCE
namespace fumage {

inline constexpr int kLifeTableSize = 1024;

/// Constants of one pass over the particles.
struct AppearanceJob {
    std::array<float, kLifeTableSize> size{}; ///< by life: share of the radius
    std::array<float, kLifeTableSize> alpha{}; ///< by life: factor of the fading alpha, opacity and dilution included
    std::int32_t step = 0;
    float dt = 0.0F;
    float lifetimeSteps = 1.0F;
    float lifetimeVariance = 0.0F;
    float initialAlpha = 0.0F;
    float fadeRate = 0.0F;
    float radius = 0.0F;
    float sizeVariance = 0.0F;
    Axes axes;
};

struct Bounds {
    glm::vec3 low{std::numeric_limits<float>::max()};
    glm::vec3 high{std::numeric_limits<float>::lowest()};
};

} // namespace fumage
#endif

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

Bounds appearanceChunk(const AppearanceJob& job, const Particles& particles, std::size_t chunk, Appearance& out)
{
    const hn::ScalableTag<float> d;
    const hn::RebindToSigned<decltype(d)> di;
    const hn::RebindToUnsigned<decltype(d)> du;
    using V = hn::Vec<decltype(d)>;
    const V one = hn::Set(d, 1.0F);
    const V zero = hn::Zero(d);
    const V fullLife = hn::Set(d, job.lifetimeSteps);
    const V far = hn::Set(d, std::numeric_limits<float>::max());
    V low[3] = {far, far, far};
    V high[3] = {hn::Neg(far), hn::Neg(far), hn::Neg(far)};
    const std::size_t begin = chunk * Particles::kChunk;
    for (std::size_t i = begin; i < begin + Particles::kChunk; i += hn::Lanes(d)) {
        const auto key = hn::Load(du, particles.key.data() + i);
        const auto birth = hn::Load(di, particles.birthStep.data() + i);
        const V age = hn::ConvertTo(d, hn::Sub(hn::Set(di, job.step), birth));
        const V random = unitStream(d, key, kLifetimeStream);
        const V lifetime = hn::Mul(fullLife, hn::Sub(one, hn::Mul(hn::Set(d, job.lifetimeVariance), random)));
        const auto alive = hn::And(hn::Lt(age, lifetime), hn::Ge(age, zero));
        const V life = hn::IfThenElseZero(alive, hn::Div(age, lifetime));
        const V fading = hn::Mul(hn::Set(d, job.fadeRate), hn::Div(fullLife, lifetime));
        const V faded = hn::Max(zero, hn::Sub(hn::Set(d, job.initialAlpha), hn::Mul(fading, hn::Mul(age, hn::Set(d, job.dt)))));
        const auto entry = hn::ConvertTo(di, hn::Mul(life, hn::Set(d, static_cast<float>(kLifeTableSize - 1))));
        const V alpha = hn::Min(one, hn::Mul(faded, hn::GatherIndex(d, job.alpha.data(), entry)));
        const V varied = hn::Sub(one, hn::Mul(hn::Set(d, job.sizeVariance), unitStream(d, key, kSizeStream)));
        const V radius = hn::Mul(hn::Mul(hn::Set(d, job.radius), hn::GatherIndex(d, job.size.data(), entry)), varied);
        const auto visible = hn::And(alive, hn::Gt(alpha, zero));
        hn::Store(hn::IfThenElseZero(visible, radius), d, out.radius.data() + i);
        hn::Store(hn::IfThenElseZero(visible, alpha), d, out.alpha.data() + i);
        hn::Store(life, d, out.life.data() + i);

        const V x = hn::Load(d, particles.x.data() + i);
        const V y = hn::Load(d, particles.y.data() + i);
        const V z = hn::Load(d, particles.z.data() + i);
        const auto along = [&](const glm::vec3& axis, V& lowest, V& highest) {
            const V c = hn::Add(hn::Add(hn::Mul(x, hn::Set(d, axis.x)), hn::Mul(y, hn::Set(d, axis.y))), hn::Mul(z, hn::Set(d, axis.z)));
            lowest = hn::Min(lowest, hn::IfThenElse(visible, c, far));
            highest = hn::Max(highest, hn::IfThenElse(visible, c, hn::Neg(far)));
        };
        along(job.axes.u, low[0], high[0]);
        along(job.axes.v, low[1], high[1]);
        along(job.axes.w, low[2], high[2]);
    }
    Bounds bounds;
    for (int i = 0; i < 3; ++i) {
        bounds.low[i] = hn::GetLane(hn::MinOfLanes(d, low[i]));
        bounds.high[i] = hn::GetLane(hn::MaxOfLanes(d, high[i]));
    }
    return bounds;
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(appearanceChunk);

namespace {

AppearanceJob makeJob(const Frame& frame, const Effect& effect, const Axes& axes)
{
    const Schedule& schedule = frame.model->schedule();
    AppearanceJob job;
    job.step = static_cast<std::int32_t>(frame.step);
    job.dt = schedule.dt;
    job.lifetimeSteps = static_cast<float>(schedule.lifetimeSteps);
    job.lifetimeVariance = effect.life.lifetimeVariance;
    job.initialAlpha = effect.life.initialAlpha;
    job.fadeRate = effect.life.fadeRate;
    job.radius = 0.5F * effect.look.size;
    job.sizeVariance = effect.look.sizeVariance;
    job.axes = axes;
    // A particle that starts from nothing would be infinitely dense: dilution counts from a tenth of the size on.
    constexpr float kSmallestShare = 0.1F;
    const float start = std::max(kSmallestShare, effect.life.sizeCurve.at(0.0F));
    for (int i = 0; i < kLifeTableSize; ++i) {
        const float life = static_cast<float>(i) / static_cast<float>(kLifeTableSize - 1);
        const float share = effect.life.sizeCurve.at(life);
        const float thinned = share > start ? start * start / (share * share) : 1.0F;
        const float dilution = 1.0F + effect.look.dilution * (thinned - 1.0F);
        job.size[static_cast<std::size_t>(i)] = share;
        job.alpha[static_cast<std::size_t>(i)] = effect.life.alphaCurve.at(life) * effect.look.opacity * dilution;
    }
    return job;
}

} // namespace

void findAppearance(const Frame& frame, const SampledEffect& effect, const Axes& axes, Appearance& out)
{
    const Particles& particles = frame.particles;
    const std::size_t padded = particles.x.size();
    out.radius.resize(padded);
    out.alpha.resize(padded);
    out.life.resize(padded);
    const AppearanceJob job = makeJob(frame, effect, axes);
    std::vector<Bounds> bounds(particles.chunks());
    parallelFor(particles.chunks(), [&](std::size_t chunk) { bounds[chunk] = HWY_DYNAMIC_DISPATCH(appearanceChunk)(job, particles, chunk, out); });
    Bounds all;
    for (const Bounds& each : bounds) {
        for (int i = 0; i < 3; ++i) {
            all.low[i] = std::min(all.low[i], each.low[i]);
            all.high[i] = std::max(all.high[i], each.high[i]);
        }
    }
    out.low = all.low;
    out.high = all.high;
    out.empty = !(all.low.x <= all.high.x);
    out.largestMass = kPi * job.radius * job.radius;
}

} // namespace fumage
#endif
