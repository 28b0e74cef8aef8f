#pragma once

#include "core/base/aligned_array.h"
#include "core/effect/effect.h"

#include <vector>

namespace fumage {

/// Where the pixels of a row lie in the cells of an octave; the same for all rows. Where whole numbers of pixels make a
/// cell, f, w and the lanes repeat along the row: only the first repeat of them is kept, so that the tables of all
/// octaves fit the first-level cache.
struct RowPositions {
    AlignedArray<float> fraction; ///< f, the place of each pixel of a repeat in its cell, in [0, 1)
    AlignedArray<float> weight; ///< w(f); see weighByInterpolation() and weighBySquare()
    /// Cell of each pixel of a repeat, counted from that of the first pixel of its block of kBlock
    AlignedArray<std::int32_t> lane;
    std::vector<std::int32_t> cell; ///< cell of the first pixel of each block of kBlock pixels
    bool uniform = false; ///< every block of kBlock pixels lies in one cell

    static constexpr std::size_t kBlock = kAlignment / sizeof(float); ///< the widest vector
};

/// Which cells pixels are counted in.
enum class CellBorders {
    OnPoints, ///< a cell lies between two lattice points: c and c + 1
    BetweenPoints ///< a cell lies around a lattice point: cell c from c - 1/2 to c + 1/2
};

/// The cell of a pixel's centre, and its place in there.
struct CellPlace {
    int cell = 0;
    float fraction = 0.0F; ///< in [0, 1), rounded once: pixels that lie alike in their cells get the same bits
};
[[nodiscard]] CellPlace placeInCells(int pixel, int size, int cells, CellBorders borders);

/// Positions of size pixels over cells cells, without weights.
/// @param size  1 or more; the last block is filled up with the last pixel
/// @param cells 1 to size, so that no cell is without a pixel
[[nodiscard]] RowPositions rowPositions(int size, int cells, CellBorders borders);

/// w = interpolationWeight(kind, f)
void weighByInterpolation(RowPositions& positions, Interpolation kind);
/// w = f^2, as cubic interpolation of values needs
void weighBySquare(RowPositions& positions);

} // namespace fumage
