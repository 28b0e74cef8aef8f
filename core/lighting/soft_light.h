#pragma once

#include "core/lighting/light_grid.h"

namespace fumage {

/// Spreads what each cell of a grid holds over its neighbours: weights of s, 1 - 2 s, s along each axis; beyond the
/// border is what lies on it. s is 1/4 of the square of the finest cell over the cell, so that light is spread as far,
/// whatever the number of particles has made of the cells.
///
/// A particle is about as large as a cell, and takes its light at its centre. Where dense smoke ends, the light falls
/// from one centre to the next, and whichever particle lies in front was seen as a ball. Light that has been scattered
/// once or twice is smooth over a mean free path, which the sum of orders in lightSmoke() leaves out; and what a
/// particle shows is a mean over its ball.
/// @param values `channels` floats a cell
/// @param room   as many floats, while it works
/// O(cells). The same bits for any thread count and instruction set. What is the same everywhere stays so to the bit;
/// the sum of all cells is kept but for what lies at the border.
void softenCells(const GridShape& shape, std::size_t channels, AlignedArray<float>& values, AlignedArray<float>& room);

/// The same for the light of a grid; light that is the same everywhere stays as it is.
void softenLight(LightGrid& grid, LightWorkspace& room);

} // namespace fumage
