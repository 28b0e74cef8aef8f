#pragma once

#include "tests/export/small_smoke.h"

#include "core/scene/scene.h"

namespace fumage::tests {

/// Smoke, clear flames in the middle of it, and some that is coloured: all through one another.
inline Scene fire()
{
    Effect effect = smallSmoke();
    effect.emitter.count = 600;
    effect.look.opacity = 8.0F;
    effect.look.colour = {0.7F, 0.7F, 0.8F};
    Scene scene = effect;
    scene.layers[0].name = "Smoke";
    effect.emitter.seed = 7;
    effect.glow.emission = 6.0F;
    effect.glow.flameOpacity = 0.1F;
    effect.look.opacity = 4.0F;
    scene.layers.emplace_back();
    scene.assign(1, effect);
    scene.layers[1].name = "Flames";
    effect.glow.emission = 0.0F;
    effect.look.opacity = 20.0F;
    effect.look.colour = {0.9F, 0.1F, 0.05F};
    effect.emitter.seed = 11;
    effect.emitter.count = 60;
    scene.layers.emplace_back();
    scene.assign(2, effect);
    scene.layers[2].name = "Red ash";
    scene.output.viewTransform = ViewTransform::Filmic;
    return scene;
}

} // namespace fumage::tests
