#pragma once

#include "core/simulation/simulation_model.h"
#include "core/simulation/particles.h"

#include <memory>
#include <span>

namespace fumage {

/// The smoke at one frame: a pure function of (effect, frame number).
struct Frame {
    std::shared_ptr<const SimulationModel> model;
    int number = 0;
    std::int64_t step = 0;
    Particles particles;
};

/// A share of a frame's particles as they are, evenly of all that were born: for previews, drawn with the look of
/// thinned().
/// @param share over 0, up to 1
[[nodiscard]] Frame sparse(const Frame& frame, double share);

/// A layer of a picture: its particles and its look, whose simulation part is that of the frame. Both outlive it.
struct LayerFrame {
    const Frame* frame = nullptr;
    const SampledEffect* effect = nullptr;
};

/// All layers of a picture, one or more, at the same moment. Their effects have the same surroundings: air, wind,
/// light, camera, timeline and output.
using LayerFrames = std::span<const LayerFrame>;

/// What fading and dying make of a particle; the same rules as the drawing kernels.
struct Lifecycle {
    float age = 0.0F; ///< s
    float life = 0.0F; ///< share of its life that has passed, in [0, 1)
    float alpha = 0.0F; ///< Ai - fade * age (eq. XIII), with lifetime variance as a faster fade
    bool alive = false;
    friend bool operator==(const Lifecycle&, const Lifecycle&) = default;
};

/// @param slot index below particles.capacity
[[nodiscard]] Lifecycle lifecycle(
    const SimulationModel& model, const Particles& particles, std::int64_t step, std::size_t slot);

/// The same of a frame.
[[nodiscard]] inline Lifecycle lifecycle(const Frame& frame, std::size_t slot)
{
    return lifecycle(*frame.model, frame.particles, frame.step, slot);
}

} // namespace fumage
