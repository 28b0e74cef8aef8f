#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace fumage {

enum class SolidShape {
    Box,
    Sphere
};

/// A body that the air flows around, and how it moves.
struct Solid {
    SolidShape shape = SolidShape::Box;
    glm::vec3 centre{0.0F}; ///< m
    glm::vec3 size{1.0F}; ///< edges of the box, or the diameter of the sphere in x, m
    glm::vec3 velocity{0.0F}; ///< of the centre, m/s
    glm::vec3 growth{0.0F}; ///< how fast the size changes, over the size, 1/s; of a sphere all three are alike
    friend bool operator==(const Solid&, const Solid&) = default;

    /// Whether a place lies inside.
    [[nodiscard]] bool contains(const glm::vec3& place) const
    {
        const glm::vec3 away = place - centre;
        if (shape == SolidShape::Sphere) {
            return glm::dot(away, away) < 0.25F * size.x * size.x;
        }
        return glm::all(glm::lessThan(glm::abs(away), 0.5F * size));
    }

    /// Whether its surface does not stay where it is.
    [[nodiscard]] bool moves() const { return velocity != glm::vec3(0.0F) || growth != glm::vec3(0.0F); }
    /// Velocity of the body at a place in it or on it, m/s.
    [[nodiscard]] glm::vec3 velocityAt(const glm::vec3& place) const { return velocity + growth * (place - centre); }
};

/// A body on its way from one place and size to another.
/// @param seconds that it takes, more than 0
/// @return it at the end, with the velocity and growth that take it there
[[nodiscard]] inline Solid movedBetween(const Solid& before, const Solid& after, float seconds)
{
    Solid out = after;
    out.velocity = (after.centre - before.centre) / seconds;
    out.growth = (after.size - before.size) / (after.size * seconds);
    if (after.shape == SolidShape::Sphere) {
        out.growth = glm::vec3(out.growth.x);
    }
    return out;
}

} // namespace fumage
