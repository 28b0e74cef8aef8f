#pragma once

#include "core/effect/effect.h"

#include <algorithm>

namespace fumage {

/// How steeply the disc of a sprite falls off towards its rim: 1 / softness, kept finite.
[[nodiscard]] inline float maskHardness(const Look& look)
{
    constexpr float kSharpest = 0.02F;
    return 1.0F / std::max(kSharpest, look.softness);
}

/// What is left of a sprite's opacity at a place in it: 1 in a square or a picture, clamp(hardness (1 - p^2 - q^2), 0,
/// 1)^2 in a disc.
/// @param p,q in the sprite, whose rim is at 1
[[nodiscard]] inline float maskAt(const Look& look, float p, float q)
{
    if (look.mask != MaskShape::Disc) {
        return 1.0F;
    }
    const float inside = std::clamp(maskHardness(look) * (1.0F - p * p - q * q), 0.0F, 1.0F);
    return inside * inside;
}

} // namespace fumage
