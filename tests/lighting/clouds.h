#pragma once

#include "tests/helpers.h"

namespace fumage::tests {

/// A frame with particles of one mass at chosen places; ages and lives are those of newborns.
inline Frame cloud(const Effect& effect, const std::vector<glm::vec3>& places)
{
    Frame frame;
    frame.model = std::make_shared<const SimulationModel>(sampled(effect));
    frame.step = 0;
    frame.particles.reset(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        frame.particles.x[i] = places[i].x;
        frame.particles.y[i] = places[i].y;
        frame.particles.z[i] = places[i].z;
        frame.particles.birthStep[i] = 0;
        frame.particles.key[i] = keyOf(1, i);
    }
    return frame;
}

/// Moves every particle but the first on to this share of its life.
inline void age(Frame& frame, float life)
{
    const auto steps = static_cast<std::int32_t>(life * static_cast<float>(frame.model->schedule().lifetimeSteps));
    frame.step = steps;
    frame.particles.birthStep[0] = steps;
}

/// Particles of 0.2 m and alpha 0.5, whatever their age.
inline Effect evenLook()
{
    Effect effect = thesisEffect(1);
    effect.life.sizeCurve = Curve{{0.0F, 1.0F}};
    effect.life.alphaCurve = Curve{{0.0F, 1.0F}};
    effect.look.size = 0.2F;
    effect.look.sizeVariance = 0.0F;
    effect.look.opacity = 5.0F;
    effect.look.dilution = 0.0F;
    return effect;
}

} // namespace fumage::tests
