#pragma once

#include "core/base/aligned_array.h"
#include "core/noise/fractal.h"

#include <array>
#include <vector>

namespace fumage {

/// One octave along one row of pixels, cell by cell: with f the position in a cell and w(f) a weight,
/// the noise in cell c is (c0 + c1 f) + w (d0 + d1 f). On a regular grid everything but f and w is constant along a cell.
struct RowCoefficients {
    float *c0, *c1, *d0, *d1; ///< one value a cell, padded by a vector; each starts at a multiple of kAlignment
};

/// Where the pixels of a row lie in the cells of an octave; the same for all rows. Where whole numbers of pixels make a cell, f, w and the
/// lanes repeat along the row: only the first repeat of them is kept, so that the tables of all octaves fit the first-level cache.
struct RowPositions {
    AlignedArray<float> fraction; ///< f of each pixel of a repeat
    AlignedArray<float> weight; ///< w(f)
    AlignedArray<std::int32_t> lane; ///< cell of each pixel of a repeat, counted from that of the first pixel of its block of kBlock
    std::vector<std::int32_t> cell; ///< cell of the first pixel of each block of kBlock pixels
    bool uniform = false; ///< every block of kBlock pixels lies in one cell

    static constexpr std::size_t kBlock = kAlignment / sizeof(float); ///< the widest vector
};

/// Gradients of one row of lattice points, blended between two layers of z.
struct LatticeRow {
    float *x, *y, *z; ///< x and y components; the part of the dot product along z; padded and aligned as RowCoefficients
    int row = -1; ///< which row, after wrapping; -1: none
};

/// Fills positions for size pixels over cells cells.
/// @param squareWeight w = f^2, as cubic interpolation of values needs, instead of that of the kind
[[nodiscard]] RowPositions rowPositions(int size, int cells, Interpolation kind, bool squareWeight);

/// Gradients of lattice row y, blended in z: x = mix(gx), y = mix(gy), z = mix(gz0 fz, gz1 (fz - 1)).
/// @param layers the two layers of z; fz in [0, 1). With weightZ = 0 only the first counts
void fillGradientRow(const Octave& octave, int y, std::array<int, 2> layers, float fz, float weightZ, LatticeRow& row);

/// Coefficients of one pixel row of gradient noise between two lattice rows.
void fillGradientCoefficients(const LatticeRow& below, const LatticeRow& above, float fy, float weightY, float amplitude, int cells, RowCoefficients& out);

/// values[i] += noise of the row, for all pixels.
void addRow(const RowPositions& positions, const RowCoefficients& coefficients, float* values);

/// values[i] += amplitude * simplex noise at ((i + 1/2) / size, y, z) of the tile.
/// Source: Perlin 2001; on a lattice that repeats, see simplex-inl.h.
/// @param y,z lattice units
void addSimplexRow(const Octave& octave, int size, float y, float z, float* values);

} // namespace fumage
