#pragma once

#include "core/flow/cells.h"

#include <array>
#include <vector>

namespace fumage {

/// One axis of a level: the second difference of the pressure, and how the next coarser level lies on this one.
/// An odd last cell has a coarse cell to itself, which is then narrower than the others; so widths differ and every
/// number is kept a cell.
struct MultigridAxis {
    int cells = 0;
    std::vector<float> width; ///< in cells of the finest level
    AirColumn below; ///< weight of p[i - 1] - p[i]; 0 at a border
    AirColumn above; ///< weight of p[i + 1] - p[i]; 0 at a border
    AirColumn own; ///< weight of -p[i]: both, and on an open border that of the face, where p is 0
    AirColumn share; ///< of a cell's width in that of its coarse one
    AirColumn within; ///< weight of a coarse cell in the interpolated value of each of its own
    AirColumn beside; ///< and of that one's neighbour, on the side of the fine cell
};

/// A grid of pressures, each level half as fine as the one before.
struct MultigridLevel {
    explicit MultigridLevel(const glm::ivec3& cells)
        : layout(cells)
    {
    }

    ColumnLayout layout;
    std::array<MultigridAxis, 3> axis;
    AirColumn pressure; ///< unused on the finest, whose columns are the caller's
    AirColumn rightSide;
    AirVectors open; ///< share of a lower face that lets air through; empty where there is no obstacle
    AirColumn inverse; ///< of the weight of -p, with obstacles; 0 in them
};

} // namespace fumage
