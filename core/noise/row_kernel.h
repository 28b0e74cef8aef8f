#pragma once

#include "core/noise/fractal.h"
#include "core/noise/row_positions.h"

#include <array>

namespace fumage {

// Rows of lattice points and columns of coefficients are arrays of at least cells + kRowPadding floats, at a multiple
// of kAlignment, with kRowMargin floats before them: index -1 is the last point again, cells and cells + 1 are the
// first two.

inline constexpr std::size_t kRowMargin = RowPositions::kBlock;
inline constexpr std::size_t kRowPadding = 2 * RowPositions::kBlock;

/// One octave along one row of pixels, cell by cell: with f the position in a cell and w(f) a weight,
/// the noise in cell c is (c0 + c1 f) + w (d0 + d1 f). On a regular grid everything but f and w is constant along a
/// cell.
struct RowCoefficients {
    float *c0, *c1, *d0, *d1; ///< one value a cell
};

/// Gradients of one row of lattice points.
struct GradientRow {
    float *x, *y, *z; ///< for gradient noise z is the part of the dot product along z
};

/// Rows of lattice values around one row of pixels, and where that lies between them.
struct ValueRows {
    std::array<std::array<const float*, 4>, 4>
        rows; ///< [plane][row]: those below and above; for cubic the four of interpolateCubic()
    bool cubic = false;
    bool flat = false; ///< only the first plane counts
    float alongY = 0.0F; ///< the weight of the row above, or for cubic the place between b and c
    float alongZ = 0.0F;
};

/// Gradients of lattice row y, blended in z: x = mix(gx), y = mix(gy), z = mix(gz0 fz, gz1 (fz - 1)).
/// @param planes the two planes of z; fz in [0, 1). With weightZ = 0 only the first counts
void fillGradientRow(
    const Octave& octave, int y, std::array<int, 2> planes, float fz, float weightZ, const GradientRow& row);

/// Coefficients of one pixel row of gradient noise between two lattice rows.
void fillGradientCoefficients(const GradientRow& below, const GradientRow& above, float fy, float weightY,
    float amplitude, int cells, const RowCoefficients& out);

/// latticeValue() of row y in plane z, both already within the period.
void fillValueRow(const Octave& octave, int y, int z, float* values);

/// smoothedLatticeValue() of the middle one of three rows.
void smoothValueRow(const std::array<const float*, 3>& rows, float amount, int cells, float* values);

/// Coefficients of one pixel row of value noise about 0; c1 and d1 only for cubic, where w must be f^2.
void fillValueCoefficients(const ValueRows& rows, float amplitude, int cells, const RowCoefficients& out);

/// values[i] += noise of the row, for all pixels.
void addRow(const RowPositions& positions, const RowCoefficients& coefficients, float* values);

/// The same where c1 and d1 are 0.
void addFlatRow(const RowPositions& positions, const RowCoefficients& coefficients, float* values);

} // namespace fumage
