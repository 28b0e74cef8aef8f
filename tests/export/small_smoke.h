#pragma once

#include "core/effect/effect.h"

namespace fumage::tests {

/// Few particles without air in a small picture: where what is in it does not matter.
inline Effect smallSmoke()
{
    Effect effect;
    effect.air.enabled = false;
    effect.emitter.count = 300;
    effect.noise.slices = 4;
    effect.noise.resolution = 16;
    effect.output.width = 24;
    effect.output.height = 24;
    return effect;
}

} // namespace fumage::tests
