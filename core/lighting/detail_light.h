#pragma once

#include "core/lighting/detail_field.h"
#include "core/lighting/light_field.h"

namespace fumage {

/// Puts the detail into the density that throws shadow, with its mean kept: folds then lie in the shade. The density as
/// it was stays beside it, for those who ask how much smoke there is.
/// @param grid with shape and density
/// O(cells with smoke)
void putDetailIntoDensity(const DetailField& detail, LightGrid& grid);

/// How deep in smoke a cell is, counting what is within a wave of it along the axes: 1 - e^(-0.4 D wave), D the most
/// density there. What is thin, or apart, shows less detail.
/// @param grid with its densities
/// @param body gets a number a cell, 0 to 1, and padding
void findBody(const DetailField& detail, const LightGrid& grid, AlignedArray<float>& body);

} // namespace fumage
