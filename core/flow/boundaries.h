#pragma once

#include "core/flow/cells.h"

namespace fumage {

// Each fills the ghosts beside one plane of cells, and the plane of ghosts beyond it where it is the first or the last:
// what fills them is the plane alone, so that the body of a parallel loop does it for the plane that it has just
// written.

/// A wall mirrors the air; through an open border goes what is inside, or comes, without heat and at least as fast as
/// the wind, what is outside.
/// @param quads air or guess
/// @param wind of the air outside, m/s
void fillQuadGhosts(const AirCells& cells, AirColumn& quads, const glm::vec3& wind, int k);

/// A wall mirrors the velocity; an open border has that of the cell within.
void fillVelocityGhosts(const AirCells& cells, AirVectors& velocity, int k);

/// As of the cell within.
void fillEvenGhosts(const AirCells& cells, AirColumn& column, int k);

/// A wall has the pressure of the cell within; on an open border it is 0.
void fillPressureGhosts(const AirCells& cells, AirColumn& pressure, int k);

/// Air outside is at rest but for the wind: what comes in through an open border faster got that speed from a pressure
/// u^2 / 2 below the one outside, which the border, at 0, does not have. That difference acts on the border's cells;
/// without it a draught through the box never ends. Changes forced, in plane k and in the ghosts beside it, which are
/// to be filled afterwards.
void slowInflow(AirCells& cells, const glm::vec3& wind, float dt, int k);

} // namespace fumage
