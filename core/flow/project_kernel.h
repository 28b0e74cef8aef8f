#pragma once

#include "core/flow/cells.h"
#include "core/flow/field.h"

namespace fumage {

// What makes the accelerated air free of divergence. Each is called for one plane; planes may run in parallel. The same
// bits on every instruction set. The velocity through the face between two cells is (a + b) / 2 - (p' - p), and 0 where
// an obstacle is.

/// What flows out of each cell, less what its source adds, which divergence holds before. Reads forced with its ghosts.
void findDivergence(AirCells& cells, int k);

/// air = forced less the mean of the pressure's differences across a cell's faces. Reads forced, heat, and pressure
/// with its ghosts.
void subtractGradient(AirCells& cells, int k);

/// The velocities through the faces, smoothed onto the corners of cells, and the heat, as half floats.
/// Reads forced, heat and pressure with their ghosts, after findDivergence().
/// @param k plane of nodes, 0 to cells
void writeNodes(const AirCells& cells, AirField& field, int k);

} // namespace fumage
