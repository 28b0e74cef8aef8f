#pragma once

#include "core/effect/effect.h"

#include <array>

#include <glm/vec3.hpp>

namespace fumage {

/// Whether what glows is less opaque than its smoke.
[[nodiscard]] inline bool hasClearFlames(const Light& light)
{
    return light.emission > 0.0F && light.flameOpacity < 1.0F;
}

/// By heat, from none to that at birth.
inline constexpr int kGlowTableSize = 256;

/// Colours of the glow, without its strength.
[[nodiscard]] std::array<glm::vec3, kGlowTableSize> glowColours(const Light& light);

/// How hot particles look, and how opaque they are while they glow.
struct Glow {
    float heatVariance = 0.0F; ///< heat at birth is between 1 minus this and 1
    float cooling = 0.0F; ///< 1/s, on top of the air's
    bool clears = false; ///< what glows is less opaque
    std::array<float, kGlowTableSize> opaque{}; ///< share of the opacity; soot forms where the glow ends

    Glow() = default;
    /// O(table); a quarter of a millisecond for a black body that clears.
    explicit Glow(const Effect& effect);
};

} // namespace fumage
