#pragma once

#include "core/export/sheets/sheet_grid.h"

namespace fumage {

/// Fits motion vectors to the pictures that engines move by them.
///
/// What flows through a shape that stays, as a fountain's drops do, moves farther than what is seen. With C_i the
/// pictures and m_i the vectors, |C_i(uv - g m_i / 2) - C_i+1(uv + g m_i+1 / 2)|^2, summed around each pixel, is
/// measured for g = 0, 1/2 and 1; the vectors are multiplied by the g at which the parabola through the three is least.
/// Vectors of less than about a pixel are taken back to 0: between two pixels a picture is blurred, and within one a
/// cross-fade is sharper. The cell after the last of a loop is its first; else the last has the g of the pair before
/// it, and the first that of the pair after.
/// @param colour premultiplied
/// @param motion straight: to the right and up, as shares of a cell
/// O(pixels). The same bits for any thread count.
void refineMotion(const Image& colour, const SheetGrid& grid, Image& motion);

} // namespace fumage
