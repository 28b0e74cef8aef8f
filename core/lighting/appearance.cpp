#include "core/lighting/appearance.h"

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/lighting/appearance_kernel.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include <glm/common.hpp>

namespace fumage {

namespace {

AppearanceJob makeJob(const Frame& frame, const Effect& effect, const Axes& axes)
{
    const Schedule& schedule = frame.model->schedule();
    AppearanceJob job;
    job.step = static_cast<std::int32_t>(frame.step);
    job.dt = schedule.dt;
    job.bornBetweenSteps = schedule.betweenSteps;
    job.lifetimeSteps = static_cast<float>(schedule.lifetimeSteps);
    job.lifetimeVariance = effect.life.lifetimeVariance;
    job.initialAlpha = effect.life.initialAlpha;
    job.fadeRate = effect.life.fadeRate;
    job.radius = 0.5F * effect.look.size;
    job.sizeVariance = effect.look.sizeVariance;
    job.heatOpacity = frame.particles.inAir() ? effect.look.heatOpacity : 0.0F;
    job.ground = effect.air.groundHeight;
    job.groundFade = effect.look.groundFade;
    if (hasClearFlames(effect.glow)) {
        job.glow = GlowTable(effect, glowColours(effect.glow));
    }
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

std::array<glm::vec3, kColourTableSize> coloursOverLife(const Look& look)
{
    std::array<glm::vec3, kColourTableSize> colours{};
    for (std::size_t i = 0; i < colours.size(); ++i) {
        colours[i] =
            look.colour * look.colourGradient.at(static_cast<float>(i) / static_cast<float>(kColourTableSize - 1));
    }
    return colours;
}

void findAppearance(
    const Frame& frame, const SampledEffect& effect, const Axes& axes, Appearance& out, const GreyCounts& greys)
{
    const Particles& particles = frame.particles;
    const std::size_t padded = particles.x.size();
    out.radius.resize(padded);
    out.alpha.resize(padded);
    out.life.resize(padded);
    out.cover = coverageOf(effect->look, greys);
    out.left.resize(out.cover.erodes ? padded : 0);
    const AppearanceJob job = makeJob(frame, effect, axes);
    Bounds all;
    out.largestMass = 0.0F;
    out.largestRadius = 0.0F;
    out.count = 0;
    std::mutex adding; // sums and bounds are the same in any order
    parallelFor(particles.chunks(), [&](std::size_t chunk) {
        const ChunkExtent each = findAppearanceOfChunk(job, particles, chunk, out);
        const std::lock_guard lock(adding);
        all.low = glm::min(all.low, each.centres.low);
        all.high = glm::max(all.high, each.centres.high);
        out.largestMass = std::max(out.largestMass, each.largestMass);
        out.largestRadius = std::max(out.largestRadius, each.largestRadius);
        out.count += each.count;
    });
    out.low = all.low;
    out.high = all.high;
}

Status checkBounds(const Appearance& appearance)
{
    const glm::vec3 extent = appearance.high - appearance.low;
    if (appearance.count == 0 || std::isfinite(extent.x + extent.y + extent.z)) {
        return Done{};
    }
    return Error{ErrorCode::OutOfRange, makeMessage("the smoke has left all bounds: a particle is nowhere"),
        std::string("motion"),
        makeMessage("Lower forces and speeds, such as motion.buoyancy, source.expansion or turbulence.strength")};
}

} // namespace fumage
