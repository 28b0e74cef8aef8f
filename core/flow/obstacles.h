#pragma once

#include "core/flow/cells.h"
#include "core/flow/solid.h"

#include <span>

namespace fumage {

/// What placeSolids() has done.
enum class SolidsPlaced {
    Nowhere, ///< no cell of air would be left, and nothing has changed
    AsBefore, ///< the same cells are walls as before
    Elsewhere, ///< others are
};

/// Makes cells whose centres lie in a solid walls: no face of theirs lets air through, and where the solid moves, they
/// move with it. Cells that were walls of solids before are air again.
/// Allocates only the first time that any cell is a wall, or is one of a solid that moves.
[[nodiscard]] SolidsPlaced placeSolids(AirCells& cells, std::span<const Solid> solids);

/// Gives the cells of obstacles that have air beside them the velocity, mirrored at the wall as that moves, and the
/// heat of that air, so that what is interpolated between them slides along the wall.
/// @param quads air or guess, of which all planes are written
void fillHalo(const AirCells& cells, AirColumn& quads);

} // namespace fumage
