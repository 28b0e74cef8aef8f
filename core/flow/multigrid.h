#pragma once

#include "core/flow/multigrid_level.h"

#include <vector>

namespace fumage {

/// Solves sum of (p' - p) over the six faces of a cell = right side, with p = 0 on open boundaries and no difference
/// across walls.
///
/// V cycles with two red-black sweeps down and two up; restriction by mean, trilinear interpolation. Two cycles leave
/// about half a percent of the residual. Any size of each side. Room is made once; solve() allocates nothing. Source:
/// Trottenberg, Oosterlee, Schüller, "Multigrid", 2001; cell-centred and with faces as in McAdams, Sifakis, Teran 2010.
class Multigrid {
public:
    /// @param open see AirCells::open; empty without obstacles
    Multigrid(const glm::ivec3& cells, const AirBoundaries& boundaries, const AirVectors& open);

    /// Lets air through other faces. Allocates only where there were no obstacles.
    /// @param open see AirCells::open; empty without obstacles
    /// @param changed all cells with a face that has opened or closed; each other face is as it was, if there were any
    void setFaces(const AirVectors& open, const CellBox& changed);

    /// @param pressure    columns of the cells, their ghosts 0; a first guess, which becomes the solution
    /// @param rightSide   read; where the box is closed its sum has to be 0
    /// The same bits for any number of threads and on every instruction set.
    void solve(AirColumn& pressure, AirColumn& rightSide, int cycles);

private:
    void cycle(std::size_t level, AirColumn& pressure, AirColumn& rightSide);

    std::vector<MultigridLevel> m_levels;
};

} // namespace fumage
