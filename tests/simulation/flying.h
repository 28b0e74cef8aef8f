#pragma once

#include "core/effect/effect.h"

namespace fumage::tests {

/// Air at rest, with particles that only fly.
inline Effect flying(Coupling coupling)
{
    Effect effect;
    effect.emitter.count = 300;
    effect.emitter.mode = EmissionMode::Burst;
    effect.emitter.burstDuration = 0.0F;
    effect.emitter.subframe = false;
    effect.emitter.position = {0.0F, 2.0F, 0.0F};
    effect.emitter.speed = 3.0F;
    effect.emitter.spread = 40.0F;
    effect.source.feeds = false;
    effect.motion = {};
    effect.motion.drag = 0.0F;
    effect.motion.pull = 0.0F;
    effect.motion.coupling = coupling;
    effect.wind.strength = 0.0F;
    effect.turbulence.strength = 0.0F;
    effect.vortex.strength = 0.0F;
    effect.air.enabled = true;
    effect.air.resolution = kMinAirResolution;
    effect.air.turbulence = 0.0F;
    effect.life.fadeRate = 0.01F;
    effect.life.lifetimeVariance = 0.0F;
    effect.look.deformation = 0.0F;
    effect.look.roll = 0.0F;
    return effect;
}

} // namespace fumage::tests
