#pragma once

#include "core/effect/effect.h"

#include <array>

#include <glm/vec3.hpp>

namespace fumage {

/// Whether what glows is less opaque than its smoke.
[[nodiscard]] inline bool hasClearFlames(const Glow& glow)
{
    return glow.emission > 0.0F && glow.flameOpacity < 1.0F;
}

/// Luminance of linear Rec. 709.
inline constexpr glm::vec3 kLuminance{0.2126F, 0.7152F, 0.0722F};

/// By heat, from none to that at birth.
inline constexpr int kGlowTableSize = 256;

using GlowColours = std::array<glm::vec3, kGlowTableSize>;

/// Colours of the glow, without its strength. A quarter of a millisecond for a black body.
[[nodiscard]] GlowColours glowColours(const Glow& glow);

/// How hot particles look, and how opaque they are while they glow.
struct GlowTable {
    float heatVariance = 0.0F; ///< heat at birth is between 1 minus this and 1
    float cooling = 0.0F; ///< 1/s, on top of the air's
    bool clears = false; ///< what glows is less opaque
    std::array<float, kGlowTableSize> opaque{}; ///< share of the opacity; soot forms where the glow ends

    GlowTable() = default;
    /// @param colours of the effect's glow
    GlowTable(const Effect& effect, const GlowColours& colours);
};

} // namespace fumage
