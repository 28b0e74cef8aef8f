#include "core/simulation/frame.h"

#include "core/base/hash.h"
#include "core/simulation/streams.h"

namespace fumage {

Lifecycle lifecycle(const Frame& frame, std::size_t slot)
{
    const std::int32_t birth = frame.particles.birthStep[slot];
    if (birth == Particles::kUnborn) {
        return {};
    }
    const Effect& effect = frame.model->effect();
    const Schedule& schedule = frame.model->schedule();
    const float beforeBirthStep = schedule.betweenSteps ? unitFloat(frame.particles.key[slot]) : 0.0F;
    const float age = static_cast<float>(frame.step - birth) + beforeBirthStep;
    const float random = unitFloat(streamBits(frame.particles.key[slot], kLifetimeStream));
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

} // namespace fumage
