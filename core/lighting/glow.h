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

/// Luminance of linear Rec. 709.
inline constexpr glm::vec3 kLuminance{0.2126F, 0.7152F, 0.0722F};

/// By heat, from none to that at birth.
inline constexpr int kGlowTableSize = 256;

using GlowColours = std::array<glm::vec3, kGlowTableSize>;

/// Colours of the glow, without its strength. A quarter of a millisecond for a black body.
[[nodiscard]] GlowColours glowColours(const Light& light);

/// How hot particles look, and how opaque they are while they glow.
struct Glow {
    float heatVariance = 0.0F; ///< heat at birth is between 1 minus this and 1
    float cooling = 0.0F; ///< 1/s, on top of the air's
    bool clears = false; ///< what glows is less opaque
    std::array<float, kGlowTableSize> opaque{}; ///< share of the opacity; soot forms where the glow ends

    Glow() = default;
    /// @param colours of the effect's light
    Glow(const Effect& effect, const GlowColours& colours);
};

} // namespace fumage
