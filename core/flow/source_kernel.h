#pragma once

#include "core/flow/cells.h"
#include "core/flow/step.h"

namespace fumage {

// What the source does to the carried air. Each is called for one plane of cells; planes may run in parallel. The same
// bits on every instruction set.

/// Heats the air in the source and takes it along: heat becomes at least s heat (1 + unevenness m), where that is not
/// less than 0, with m noise of three octaves, the velocity along its normal goes a share relaxation s of the way to
/// its own. s is 1 inside and falls to 0 across the rim, which lies at 1 + raggedness n of the reach with n curl noise
/// that moves, root mean square 1. Writes velocity and heat, and adds to the divergence what the source adds by its
/// expansion. Nothing where it does not act, or does not reach the plane.
void addSource(AirCells& cells, const AirSource& source, int k);

/// What the unevenness of the source makes of its heat: the mean over its shape of max(0, 1 + unevenness m), at a few
/// hundred places. With heat divided by it, a source gives off as much whatever its noise is like.
[[nodiscard]] float meanUnevenness(const AirSource& source);

} // namespace fumage
