#pragma once

#include "core/flow/cells.h"

namespace fumage {

// Each fills the ghosts beside one plane of cells, and the plane of ghosts beyond it where it is the first or the last: what fills them is the
// plane alone, so that the body of a parallel loop does it for the plane that it has just written.

/// A wall mirrors the air; through an open border goes what is inside, or comes, without heat and at least as fast as the wind, what is outside.
/// @param quads air or guess
/// @param wind of the air outside, m/s
void fillQuadGhosts(const AirCells& cells, AirColumn& quads, const glm::vec3& wind, int k);

/// A wall mirrors the velocity; an open border has that of the cell within.
void fillVelocityGhosts(const AirCells& cells, AirVectors& velocity, int k);

/// As of the cell within.
void fillEvenGhosts(const AirCells& cells, AirColumn& column, int k);

/// A wall has the pressure of the cell within; on an open border it is 0.
void fillPressureGhosts(const AirCells& cells, AirColumn& pressure, int k);

} // namespace fumage
