#pragma once

#include "core/base/result.h"
#include "core/lighting/particle_appearance.h"
#include "core/simulation/frame.h"

#include <array>
#include <cstddef>

#include <glm/vec3.hpp>

namespace fumage {

inline constexpr std::size_t kColourTableSize = 256;
/// The colour of smoke itself, linear, by the share of a particle's life that has passed: entry i is at i / 255.
[[nodiscard]] std::array<glm::vec3, kColourTableSize> coloursOverLife(const Look& look);

/// @param effect the look to apply; its simulation part is that of the frame
/// @param axes   in which the bounds are taken
/// @param greys  of the texture that particles show, for what they cover; without any it is as if there were no texture
/// O(particles). Follows lifecycle() to the bit; size and alpha over life come from tables of 1024 entries.
void findAppearance(
    const Frame& frame, const SampledEffect& effect, const Axes& axes, Appearance& out, const GreyCounts& greys = {});

/// Whether grids can be laid around the particles.
/// @error OutOfRange: their bounds are not finite
[[nodiscard]] Status checkBounds(const Appearance& appearance);

} // namespace fumage
