#pragma once

#include "core/base/aligned_array.h"
#include "core/base/result.h"
#include "core/lighting/coverage.h"
#include "core/simulation/frame.h"

#include <array>
#include <cstddef>

#include <glm/vec3.hpp>

namespace fumage {

/// What the look makes of each particle of a frame: how large and how dense it is now. Dead ones have radius 0.
struct Appearance {
    AlignedArray<float> radius; ///< m
    AlignedArray<float> alpha; ///< opacity at the centre, in [0, 1]
    AlignedArray<float> life; ///< share of its life that has passed, in [0, 1)
    AlignedArray<float> left; ///< of what a newborn covers, where texture eats at particles as they age; else empty
    Coverage cover; ///< what particles cover of discs
    glm::vec3 low{0.0F}; ///< bounds of living centres in the axes that were asked for, m; infinite where one has no place
    glm::vec3 high{0.0F};
    float largestMass = 0.0F; ///< of alpha * radius^2, and what is left of it, m^2
    float largestRadius = 0.0F; ///< m
    std::size_t count = 0; ///< of living particles that are not yet transparent
};

inline constexpr std::size_t kColourTableSize = 256;
/// The colour of smoke itself, linear, by the share of a particle's life that has passed: entry i is at i / 255.
[[nodiscard]] std::array<glm::vec3, kColourTableSize> coloursOverLife(const Look& look);

/// Axes of a rotated frame of reference; unit vectors at right angles.
struct Axes {
    glm::vec3 u{1.0F, 0.0F, 0.0F};
    glm::vec3 v{0.0F, 1.0F, 0.0F};
    glm::vec3 w{0.0F, 0.0F, 1.0F};
};

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
