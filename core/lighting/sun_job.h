#pragma once

#include <glm/vec3.hpp>

namespace fumage {

/// What the sun needs at every cell.
struct SunJob {
    glm::vec3 eye{0.0F}; ///< in the axes of the grid, m
    float intensity = 1.0F;
    float shadow = 1.0F;
    float scattering = 0.0F;
    float anisotropy = 0.0F;
};

} // namespace fumage
