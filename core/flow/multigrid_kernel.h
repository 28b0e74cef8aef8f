#pragma once

#include "core/flow/multigrid_level.h"

namespace fumage {

// The parts of a cycle, for one plane of cells of a level. Planes may run in parallel. The same bits on every
// instruction set.

/// p = (sum of weighted neighbours - right side) / weights: the white cells of the plane's chess board, then the black
/// ones. Planes beside one another may not run at the same time: even ones first, then odd ones.
void relax(const MultigridLevel& level, AirColumn& pressure, const AirColumn& rightSide, int k);

/// The mean of the residual of fine cells becomes the right side of the coarse cells of plane k, whose pressure becomes
/// 0.
void restrictResidual(
    const MultigridLevel& fine, const AirColumn& pressure, const AirColumn& rightSide, MultigridLevel& coarse, int k);

/// Adds the pressure between the centres of coarse cells to that of the fine cells of plane k.
void prolong(const MultigridLevel& fine, const MultigridLevel& coarse, AirColumn& pressure, int k);

} // namespace fumage
