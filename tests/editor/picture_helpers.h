#pragma once

#include "ui/preview/picture.h"

namespace fumage::tests {

/// An effect whose pictures are made in a moment.
inline Effect smallEffect()
{
    Effect effect;
    effect.emitter.count = 2000;
    effect.turbulence.octaves = 2;
    effect.light.resolution = 24;
    effect.noise.resolution = 32;
    effect.noise.slices = 8;
    return effect;
}

/// An effect that takes hardly any time or memory.
inline Effect tinyEffect()
{
    Effect effect;
    effect.emitter.count = 200;
    effect.noise.resolution = 16;
    effect.noise.slices = 2;
    effect.light.resolution = 8;
    return effect;
}

inline ui::RenderRequest requestFor(const Effect& effect, int frame = 20)
{
    ui::RenderRequest request;
    request.scene = std::make_shared<const Scene>(effect);
    request.frame = frame;
    request.width = 160;
    request.height = 120;
    return request;
}

} // namespace fumage::tests
