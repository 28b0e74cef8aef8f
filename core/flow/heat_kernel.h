#pragma once

#include "core/flow/cells.h"

namespace fumage {

// What HeatBudget does to all cells of a plane. Sums leave cells of obstacles out; they are taken in as many sums side
// by side as make the order that of no instruction set. Planes may run in parallel. The same bits on every instruction
// set.

/// The heat of plane k of the air, in cells.
[[nodiscard]] double heatOfAir(const AirCells& cells, int k);

/// Sums over a plane of the heat that has been carried.
struct CarriedHeat {
    double all = 0.0;
    double more = 0.0; ///< that its first guess has where it has more
    double less = 0.0;
};

/// Reads heat and guess.
[[nodiscard]] CarriedHeat carriedHeat(const AirCells& cells, int k);

/// H + up max(0, G - H) + down min(0, G - H), with H the heat that has been carried and G its first guess.
void correctHeat(AirCells& cells, float up, float down, int k);

} // namespace fumage
