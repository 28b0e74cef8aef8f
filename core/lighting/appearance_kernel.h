#pragma once

#include "core/lighting/glow.h"
#include "core/lighting/particle_appearance.h"
#include "core/simulation/frame.h"

#include <array>
#include <cstdint>
#include <limits>

namespace fumage {

inline constexpr int kLifeTableSize = 1024;

/// Constants of one pass over the particles.
struct AppearanceJob {
    std::array<float, kLifeTableSize> size{}; ///< by life: share of the radius
    std::array<float, kLifeTableSize> alpha{}; ///< by life: factor of the fading alpha, opacity and dilution included
    std::int32_t step = 0;
    float dt = 0.0F;
    bool bornBetweenSteps = false;
    float lifetimeSteps = 1.0F;
    float lifetimeVariance = 0.0F;
    float initialAlpha = 0.0F;
    float fadeRate = 0.0F;
    float radius = 0.0F;
    float sizeVariance = 0.0F;
    float heatOpacity = 0.0F; ///< share of the opacity that is the heat's, where air carries the particles
    float ground = 0.0F; ///< height of the floor, m
    float groundFade = 0.0F; ///< height above it at which particles are as opaque as they get, m; 0: at once
    GlowTable glow;
    Axes axes;
};

/// Bounds of nothing, until something is in them.
struct Bounds {
    glm::vec3 low{std::numeric_limits<float>::max()};
    glm::vec3 high{std::numeric_limits<float>::lowest()};
};

/// How far the visible particles of a chunk reach.
struct ChunkExtent {
    Bounds centres; ///< in the job's axes
    float largestMass = 0.0F; ///< alpha * radius^2, m^2
    float largestRadius = 0.0F; ///< m
    std::size_t count = 0;
};

/// Fills the appearance of one chunk.
/// @param out with room for all particles
[[nodiscard]] ChunkExtent findAppearanceOfChunk(
    const AppearanceJob& job, const Particles& particles, std::size_t chunk, Appearance& out);

} // namespace fumage
