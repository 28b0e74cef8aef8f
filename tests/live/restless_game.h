#pragma once

#include "tests/effects.h"

#include "core/live/live_simulation.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>

namespace fumage::tests {

inline constexpr double kDt = 1.0 / 60.0; ///< s, a step of what is below

/// Smoke in a wind, at 60 steps a second.
inline Effect windy(int count)
{
    Effect effect = thesisEffect(count);
    effect.emitter.subframe = true;
    effect.emitter.velocityRandomness = 0.4F;
    effect.emitter.shape = EmitterShape::Disc;
    effect.wind.strength = 2.0F;
    effect.wind.gust = 0.8F;
    effect.motion.drag = effect.air.drag = 1.0F;
    effect.motion.buoyancy = effect.air.buoyancy = 1.0F;
    effect.turbulence.strength = 0.7F;
    effect.life.initialAlpha = 0.1F;
    effect.life.fadeRate = 0.05F;
    effect.timeline.frameRate = 60;
    return effect;
}

/// Warm smoke in an open box of 4 x 8 x 4 m, a quarter of a metre a cell, at 60 steps a second.
inline Effect inAir(int count)
{
    Effect effect = windy(count);
    effect.motion = {};
    effect.wind.strength = 0.0F;
    effect.wind.gust = 0.0F;
    effect.turbulence.strength = 0.0F;
    effect.air = {};
    effect.motion.drag = effect.air.drag = 1.0F;
    effect.motion.buoyancy = effect.air.buoyancy = 4.0F;
    effect.air.enabled = true;
    effect.air.fit = false;
    effect.air.size = {4.0F, 8.0F, 4.0F};
    effect.air.resolution = 32;
    effect.air.ground = false;
    effect.turbulence.detail = 0.0F;
    return effect;
}

/// A game that does with a smoke what comes into its mind: emitter, wind, rate and lifetime, the same in every run.
class RestlessGame {
public:
    /// @param most particles that it asks for in a lifetime
    explicit RestlessGame(const Effect& effect, int most = 6200)
        : m_effect(effect)
        , m_most(most)
    {
    }

    /// What it does before a step.
    /// @return what the smoke has to say against it: nothing
    /// @tparam Live a LiveSimulation, or what has its functions
    template <class Live>
    [[nodiscard]] Status act(Live& live, int step)
    {
        EmitterPose pose = live.emitter();
        pose.position += 0.3F * draw();
        pose.normal = glm::normalize(pose.normal + 0.5F * draw());
        pose.velocity = 2.0F * draw();
        if (Status moved = live.setEmitter(pose); !moved) {
            return moved;
        }
        live.setShare(step % 200 < 10 ? 0.0F : 1.0F);
        if (step % 7 != 0) {
            return Done{};
        }
        constexpr int kMin = 200;
        m_effect.emitter.count = kMin + static_cast<int>(m_random() % static_cast<unsigned>(m_most - kMin));
        m_effect.wind.strength = 4.0F * draw().x;
        m_effect.life.fadeRate = 0.04F + 0.02F * draw().x;
        return live.setEffect(m_effect);
    }

private:
    glm::vec3 draw()
    {
        const auto one = [&] {
            return static_cast<float>(m_random()) / static_cast<float>(std::mt19937::max()) * 2.0F - 1.0F;
        };
        const float x = one();
        const float y = one();
        return {x, y, one()};
    }

    Effect m_effect;
    int m_most;
    std::mt19937 m_random{2012};
};

/// Whether every number of every particle is one.
inline bool isFinite(const Particles& particles)
{
    bool finite = true;
    forEachColumn([&](const auto& column) {
        const auto& values = column.of(particles);
        finite = finite && std::all_of(values.begin(), values.end(), [](auto value) {
            return std::isfinite(static_cast<double>(value));
        });
    });
    return finite;
}

/// The farthest that a particle has gone in a step beyond what it may: its speed, and that of the swirls.
inline float longestJump(const Particles& before, const Particles& after, float swirls)
{
    float jump = 0.0F;
    for (std::size_t i = 0; i < after.capacity; ++i) {
        if (before.key[i] != after.key[i] || before.birthStep[i] != after.birthStep[i]
            || after.birthStep[i] == Particles::kUnborn) {
            continue; // not the same particle
        }
        const glm::vec3 way{after.x[i] - before.x[i], after.y[i] - before.y[i], after.z[i] - before.z[i]};
        const glm::vec3 velocity(after.vx[i], after.vy[i], after.vz[i]);
        float speed = glm::length(velocity);
        if (after.inAir()) {
            // Drag slows it down on its way through the air: the mean lies between the velocities at either end.
            const glm::vec3 slowed(before.relativeX[i] - after.relativeX[i], before.relativeY[i] - after.relativeY[i],
                before.relativeZ[i] - after.relativeZ[i]);
            speed = std::max(speed, glm::length(velocity + slowed));
        }
        jump = std::max(jump, glm::length(way) - (speed + swirls) * static_cast<float>(kDt));
    }
    return jump;
}

} // namespace fumage::tests
