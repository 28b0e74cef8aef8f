#pragma once

#include "core/lighting/fire_workspace.h"
#include "core/lighting/glow.h"
#include "core/lighting/light_field.h"
#include "core/simulation/frame.h"

#include <array>

namespace fumage {

/// How bright particles are.
struct FireJob {
    GlowTable glow;
    std::array<float, kGlowTableSize> brightness{}; ///< by heat
    float hotCore = 0.0F;
    float strength = 1.0F; ///< of its light on smoke, over that of the strongest layer
    std::int32_t step = 0;
    float dt = 0.0F;
    bool bornBetweenSteps = false;
};

/// Fills radius and alpha of what glows, and its heat, for one chunk.
/// @return the largest mass
float findFireOfChunk(const FireJob& job, const Frame& frame, const Appearance& appearance, const LightGrid& light,
    std::size_t chunk, FireWorkspace::Layer& out);

} // namespace fumage
