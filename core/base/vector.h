#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace fumage {

/// Two directions that span the plane across a unit normal; (across, normal, along) is right-handed the other way
/// round: along = across x normal. For the normal (0, 1, 0) they are +x and +z.
struct PlaneBasis {
    glm::vec3 across{1.0F, 0.0F, 0.0F};
    glm::vec3 along{0.0F, 0.0F, 1.0F};
};

/// The horizontal direction at an angle from +x towards +z, as that of the wind. The same bits on every machine.
[[nodiscard]] glm::vec3 horizontalDirection(float degrees);

/// @param normal unit vector
[[nodiscard]] PlaneBasis planeBasis(const glm::vec3& normal);

/// Whether a turn from one unit vector to another has no way of its own.
[[nodiscard]] inline bool areAlmostOpposite(const glm::vec3& a, const glm::vec3& b)
{
    constexpr float kAlmostOpposite = -0.99F;
    return glm::dot(a, b) < kAlmostOpposite;
}

} // namespace fumage
