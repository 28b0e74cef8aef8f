#pragma once

#include "core/flow/cells.h"

#include <span>

namespace fumage {

enum class SolidShape {
    Box,
    Sphere
};

/// A body that the air flows around.
struct Solid {
    SolidShape shape = SolidShape::Box;
    glm::vec3 centre{0.0F}; ///< m
    glm::vec3 size{1.0F}; ///< edges of the box, or the diameter of the sphere in x, m
    friend bool operator==(const Solid&, const Solid&) = default;

    /// Whether a place lies inside.
    [[nodiscard]] bool contains(const glm::vec3& place) const;
};

/// Makes cells whose centres lie in a solid walls: no face of theirs lets air through.
/// Cells that were walls of solids before are air again.
/// @return whether any cell of air is left; otherwise nothing has changed
[[nodiscard]] bool placeSolids(AirCells& cells, std::span<const Solid> solids);

/// Gives the cells of obstacles that have air beside them the mirrored velocity and the heat of that air, so that what
/// is interpolated between them slides along the wall.
/// @param quads air or guess, of which all planes are written
void fillHalo(const AirCells& cells, AirColumn& quads);

} // namespace fumage
