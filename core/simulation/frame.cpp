#include "core/simulation/frame.h"

#include "core/base/hash.h"
#include "core/simulation/streams.h"

#include <cmath>

namespace fumage {

Lifecycle lifecycle(const SimulationModel& model, const Particles& particles, std::int64_t step, std::size_t slot)
{
    const std::int32_t birth = particles.birthStep[slot];
    if (birth == Particles::kUnborn) {
        return {};
    }
    const Effect& effect = model.effect();
    const Schedule& schedule = model.schedule();
    const float beforeBirthStep = schedule.betweenSteps ? unitFloat(particles.key[slot]) : 0.0F;
    const float age = static_cast<float>(step - birth) + beforeBirthStep;
    const float random = unitFloat(streamBits(particles.key[slot], kLifetimeStream));
    const float lifetime = static_cast<float>(schedule.lifetimeSteps) * (1.0F - effect.life.lifetimeVariance * random);
    Lifecycle out;
    out.age = age * schedule.dt;
    out.alive = age < lifetime;
    if (out.alive) {
        out.life = age / lifetime;
        const float fading = effect.life.fadeRate * (static_cast<float>(schedule.lifetimeSteps) / lifetime);
        out.alpha = effect.life.initialAlpha - fading * out.age;
        out.alpha = out.alpha > 0.0F ? out.alpha : 0.0F;
    }
    return out;
}

Frame sparse(const Frame& frame, double share)
{
    const auto slots = static_cast<std::size_t>(std::ceil(static_cast<double>(frame.particles.capacity) * share));
    Frame out{frame.model, frame.number, frame.step, {}};
    out.particles.reset(slots, frame.particles.columns());
    forEachColumn([&](const auto& column) {
        const auto& from = column.of(frame.particles);
        auto& to = column.of(out.particles);
        for (std::size_t slot = 0; slot < slots && !from.empty(); ++slot) {
            to[slot] = from[static_cast<std::size_t>(static_cast<double>(slot) / share)];
        }
    });
    return out;
}

} // namespace fumage
