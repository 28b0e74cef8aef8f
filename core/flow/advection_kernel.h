#pragma once

#include "core/flow/cells.h"
#include "core/flow/step.h"

namespace fumage {

// The air carries itself: MacCormack's method on the second-order back trace of Stam.
//     guess(x) = q(x - d),  back(x) = guess(x + d),  q'(x) = guess(x) + (q(x) - back(x)) / 2,  limited to the eight
//     values around x - d
// with d = dt u(x - dt/2 u(x)). Each is called for one plane of cells; planes may run in parallel. The same bits on
// every instruction set. Source: Selle, Fedkiw, Kim, Liu, Rossignac, "An Unconditionally Stable MacCormack Method", J.
// Sci. Comput. 2008.

/// Finds d and the guess. Reads air and carrier with their ghosts; writes guess, and d where the accelerated air will
/// be.
void traceBack(AirCells& cells, float dt, int k);

/// Corrects the guess. Reads air, guess with its ghosts, and d; writes velocity and heat.
void correctTrace(AirCells& cells, float dt, int k);

} // namespace fumage
