#pragma once

#include "tests/helpers.h"
#include "tests/live/restless_game.h"

namespace fumage::tests {

inline LiveScene startedScene(const Scene& scene, const LiveOptions& options = {})
{
    Result<LiveScene> made = LiveScene::start(scene, options);
    if (!made) {
        qFatal("%s", made.error().text().c_str());
    }
    return std::move(made).value();
}

inline void go(LiveScene& live, int steps)
{
    for (int i = 0; i < steps; ++i) {
        QCOMPARE(live.step(live.stepSeconds()).value(), 1);
    }
}

inline const glm::vec3 kUp{0.0F, 1.0F, 0.0F};

/// An emitter at rest that points up.
inline EmitterPose at(float x, float y = 0.0F, float z = 0.0F)
{
    return {{x, y, z}, kUp, glm::vec3(0.0F)};
}

/// Adds a layer, in the surroundings of the first.
inline Layer& addLayer(Scene& scene, const char* name, std::uint32_t seed)
{
    Layer& layer = scene.layers.emplace_back(scene.layers.front());
    layer.name = name;
    layer.emitter.seed = seed;
    return layer;
}

/// A torch: flames and smoke that feed one air, embers that are dragged by it, and sparks that are born on those.
inline Scene torch(bool air = true)
{
    Effect flames = everythingOn();
    flames.air.enabled = air;
    flames.air.resolution = kMinAirResolution;
    flames.timeline.prewarm = false;
    flames.timeline.loop = false;
    flames.look.detail = 0.0F;
    flames.look.texture = 0.0F;
    flames.emitter.count = 900;
    Scene scene = flames;
    scene.layers.front().name = "flames";
    Layer& smoke = addLayer(scene, "smoke", 9);
    smoke.emitter.position.y += 0.2F;
    smoke.emitter.start = 0.2F;
    smoke.glow.emission = 0.0F;
    Layer& embers = addLayer(scene, "embers", 5);
    embers.emitter.count = 300;
    embers.emitter.length = 1.0F;
    embers.source.feeds = false;
    embers.motion.coupling = Coupling::Dragged;
    embers.life.lifetimeVariance = 0.5F;
    Layer& sparks = addLayer(scene, "sparks", 3);
    sparks.from = "embers";
    sparks.emitter.count = 400;
    sparks.emitter.inherit = 0.5F;
    sparks.motion.coupling = Coupling::Free;
    sparks.life.fadeRate *= 2.0F;
    return scene;
}

/// A point that leaves particles standing where they are born, at 60 steps a second; they live for 5 s.
inline Effect standingPoint(int count)
{
    Effect effect = thesisEffect(count);
    effect.emitter.shape = EmitterShape::Disc;
    effect.emitter.radius = 0.0F;
    effect.emitter.subframe = true;
    effect.emitter.speed = 0.0F;
    effect.timeline.frameRate = 60;
    return effect;
}

} // namespace fumage::tests
