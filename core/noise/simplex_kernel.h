#pragma once

#include "core/noise/row_kernel.h"

namespace fumage {

// Simplex noise is a sum over lattice points, t^4 (g . d) with t = max(0, 1/2 - |d|^2), d the way from the point and g
// its gradient. The points lie at whole places and half a unit from them along each axis, so in lines along x, a unit
// apart. On a row of pixels a line has one distance (dy, dz), and the sum over its points is t = reach - dx^2, g . d =
// slope dx + height. Source: Perlin 2001; Gustavson and McEwan, "Tiling simplex noise and flow noise in two and three
// dimensions", JCGT 2022.

/// A line of lattice points along x.
struct SimplexLine {
    int y = 0; ///< in halves, within the period
    int z = 0;
    bool between = false; ///< point i lies at i + 1/2, not at i
};

/// Gradients of a line, with the amplitude of the octave.
void fillSimplexLine(const Octave& octave, const SimplexLine& line, const GradientRow& out);

/// heights = y dy + z dz, for all points of a line.
void fillSimplexHeights(const GradientRow& line, float dy, float dz, int points, float* heights);

/// values[i] += what the points c and c + 1 add to the pixels of cell c.
void addPairsOfPoints(
    const RowPositions& positions, const float* slopes, const float* heights, float reach, float* values);

/// values[i] += what point c adds to the pixels of the cell around it.
void addNearestPoints(
    const RowPositions& positions, const float* slopes, const float* heights, float reach, float* values);

} // namespace fumage
