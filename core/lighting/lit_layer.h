#pragma once

#include "core/effect/tracks.h"
#include "core/lighting/detail_field.h"
#include "core/lighting/particle_appearance.h"
#include "core/simulation/frame.h"

#include <span>

namespace fumage {

/// One of the layers of smoke that light goes through together. What is pointed at outlives it.
struct LitLayer {
    const Frame* frame = nullptr;
    const Effect* effect = nullptr; ///< its look; its simulation part is that of the frame
    const Appearance* appearance = nullptr; ///< of the frame
    const DetailField* detail = nullptr; ///< null: it has none that its air carries
    const Tracks* rates = nullptr; ///< rates of each particle's own that change over time; null: none
};

/// All layers of a picture. Their effects have the same light, camera and air.
using LitLayers = std::span<const LitLayer>;

/// Bounds of all particles that are seen, in the axes of the appearances, m.
struct LitBounds {
    glm::vec3 low{0.0F};
    glm::vec3 high{0.0F};
    std::size_t count = 0; ///< of living particles in all layers
    /// Of the layer whose largest particle covers most: the largest alpha r^2, and what it covers of discs, m^2
    float largestMass = 0.0F;
    float cover = 0.0F;

    explicit LitBounds(LitLayers layers);
};

} // namespace fumage
