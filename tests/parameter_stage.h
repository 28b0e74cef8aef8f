#pragma once

#include "tests/effects.h"
#include "tests/pictures.h"

#include "core/effect/known_parameter.h"
#include "core/effect/parameter_table.h"
#include "core/effect/value.h"

namespace fumage::tests {

/// Another value of the parameter, well away from the present one.
inline Value moved(const Parameter& p, const Effect& effect)
{
    const Value value = p.get(effect);
    if (&p == &knownParameter("look.roll") || &p == &knownParameter("look.deformation")) {
        return 0.0F; // none at all: particles have no columns for it
    }
    const auto towards = [&](float from) {
        const auto low = static_cast<float>(p.soft.low);
        const auto high = static_cast<float>(p.soft.high);
        return from > 0.5F * (low + high) ? from + 0.5F * (low - from) : from + 0.5F * (high - from);
    };
    switch (p.kind) {
    case Kind::Bool: return !std::get<bool>(value);
    case Kind::Choice: return (std::get<int>(value) + 1) % static_cast<int>(p.choices.size());
    case Kind::Int:
        return &p == &knownParameter("emitter.count")
            ? 1000
            : static_cast<int>(towards(static_cast<float>(std::get<int>(value))));
    case Kind::Float: return towards(std::get<float>(value));
    case Kind::Seed: return std::get<std::uint32_t>(value) + 1U;
    case Kind::Direction: return clampValue(p, Value(std::get<glm::vec3>(value) + glm::vec3(0.7F, 0.1F, 0.4F))).value;
    case Kind::Vector: return std::get<glm::vec3>(value) + glm::vec3(0.3F, 0.2F, 0.1F);
    case Kind::Colour: return std::get<glm::vec3>(value) * glm::vec3(0.3F, 0.6F, 0.9F);
    case Kind::Curve: return Curve{{0.0F, 0.5F}, {1.0F, 0.2F}};
    case Kind::Gradient: return Gradient{{0.0F, glm::vec3(0.1F, 0.5F, 0.9F)}, {1.0F, glm::vec3(0.9F, 0.1F, 0.3F)}};
    case Kind::Picture: return ramp(16, 16);
    }
    return value;
}

/// Some of the others have no effect in air, which makes its own rings and large swirls.
inline void putInAir(Effect& effect)
{
    effect.air.enabled = true;
    effect.air.resolution = 24;
    effect.air.obstacle = Obstacle::Sphere;
    effect.air.obstaclePosition = {0.3F, 0.8F, 0.0F};
    effect.air.friction = 0.2F;
    effect.air.size = {2.0F, 3.0F, 2.0F};
    effect.air.groundHeight = 0.1F;
    effect.air.turbulence = 3.0F;
    effect.emitter.position.y = 0.2F;
    effect.timeline.prewarm = false;
}

/// The effect with everything on, and with what makes this parameter visible.
inline Effect stageFor(const Parameter& p)
{
    Effect effect = everythingOn();
    effect.camera.target = {0.0F, 1.7F, 0.0F};
    effect.camera.distance = 6.0F; // so near that sprites show their texture
    if (p.group() == "air" || (p.visible.key == "air.enabled" && p.visible.value != 0)) {
        putInAir(effect);
    }
    if (&p == &knownParameter("look.deformation_limit")) {
        effect.look.deformationLimit = 1.02F; // so early nothing is stretched by much
    }
    if (&p == &knownParameter("motion.restitution") || &p == &knownParameter("motion.friction")) {
        effect.motion.coupling = Coupling::Dragged;
        effect.motion.gravity = 60.0F; // so that many have touched the ground soon
    }
    if (&p == &knownParameter("noise.smooth")) {
        effect.noise.basis = NoiseBasis::Lattice;
    }
    if (const Parameter* other = findParameter(p.visible.key); other != nullptr) {
        if (other->kind == Kind::Bool) {
            other->set(effect, p.visible.value != 0);
        } else {
            other->set(effect, p.visible.value);
        }
    }
    if (&p == &knownParameter("timeline.prewarm")) {
        effect.timeline.loop = false;
    }
    if (&p == &knownParameter("timeline.length")) {
        effect.timeline.loop = true;
    }
    return effect;
}

} // namespace fumage::tests
