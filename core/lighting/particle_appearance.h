#pragma once

#include "core/base/aligned_array.h"
#include "core/lighting/coverage.h"

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
    glm::vec3 low{
        0.0F}; ///< bounds of living centres in the axes that were asked for, m; infinite where one has no place
    glm::vec3 high{0.0F};
    float largestMass = 0.0F; ///< of alpha * radius^2, and what is left of it, m^2
    float largestRadius = 0.0F; ///< m
    std::size_t count = 0; ///< of living particles that are not yet transparent
};

/// Axes of a rotated frame of reference; unit vectors at right angles.
struct Axes {
    glm::vec3 u{1.0F, 0.0F, 0.0F};
    glm::vec3 v{0.0F, 1.0F, 0.0F};
    glm::vec3 w{0.0F, 0.0F, 1.0F};
};

} // namespace fumage
