#pragma once

#include "core/flow/cells.h"

namespace fumage {

/// Moves the state within plane k, as if the box had gone on by whole cells: cell c has what cell c + by had. What
/// comes in is cold and moves with the wind; obstacles, which are those where the box is now, are at rest. Ghosts and
/// the skin of obstacles are to be filled afterwards.
/// @param from quads of the state as it was
/// @param to   other quads
void shiftPlane(
    const AirCells& cells, const AirColumn& from, const glm::ivec3& by, const glm::vec3& wind, AirColumn& to, int k);

} // namespace fumage
