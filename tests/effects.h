#pragma once

#include "core/effect/effect.h"

namespace fumage::tests {

/// An effect with few particles and everything of part 2 switched on, so that every parameter has something to change.
inline Effect everythingOn()
{
    Effect e;
    e.emitter.count = 1500;
    e.emitter.velocityRandomness = 0.3F;
    e.source.surge = 0.5F;
    e.source.surgeRate = 3.0F;
    e.wind.strength = 0.6F;
    e.motion.gravity = 0.2F;
    e.motion.randomness = 0.4F;
    e.motion.rotation = 20.0F;
    e.motion.rotationJitter = 10.0F;
    e.turbulence.octaves = 2;
    e.vortex.strength = 0.4F;
    e.look.size = 0.6F;
    e.look.texture = 0.9F;
    e.look.erosion = 0.6F;
    e.look.relief = 0.5F;
    e.look.roundness = 0.3F;
    e.look.spin = 10.0F;
    e.look.roll = 0.5F;
    e.look.stretch = 0.05F;
    e.look.detail = 1.0F;
    e.look.detailSize = 0.8F;
    e.glow.emission = 2.0F;
    e.glow.hotCore = 0.3F;
    e.glow.flameOpacity = 0.5F;
    e.noise.basis = NoiseBasis::Gradient;
    e.noise.resolution = 32;
    e.noise.slices = 8;
    e.noise.octaves = 3;
    e.light.resolution = 24;
    e.camera.turntable = 10.0F;
    e.output.width = 96;
    e.output.height = 96;
    e.output.background = Background::Colour;
    return e;
}

/// The motion of the 2012 model alone: no part 2, nothing random but what a test switches on.
inline Effect thesisEffect(int count)
{
    Effect e;
    e.emitter = {};
    e.emitter.shape = EmitterShape::Rectangle;
    e.emitter.width = 1.0F;
    e.emitter.depth = 1.0F;
    e.emitter.count = count;
    e.emitter.speed = 1.0F;
    e.emitter.velocityRandomness = 0.0F;
    e.emitter.spread = 0.0F;
    e.emitter.subframe = false;
    e.motion = {};
    e.wind.strength = 0.0F;
    e.wind.gust = 0.0F;
    e.motion.drag = e.air.drag = 0.0F;
    e.motion.buoyancy = e.air.buoyancy = 0.0F;
    e.motion.heatVariance = 0.0F;
    e.motion.pull = 0.0F;
    e.turbulence.strength = 0.0F;
    e.rings.strength = 0.0F;
    e.life.initialAlpha = 0.1F;
    e.life.fadeRate = 0.02F;
    e.life.lifetimeVariance = 0.0F;
    e.timeline.frameRate = 30;
    e.timeline.prewarm = false;
    return e;
}

} // namespace fumage::tests
