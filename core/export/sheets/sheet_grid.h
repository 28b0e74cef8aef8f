#pragma once

#include "core/base/parallel.h"
#include "core/rendering/image.h"

#include <algorithm>

#include <glm/common.hpp>

namespace fumage {

/// A part of a sheet, in pixels of it.
struct SheetCell {
    int left = 0;
    int top = 0;
    int width = 1;
    int height = 1;
};

/// Where the cells of a sheet lie: first at the top left, then along the rows.
struct SheetGrid {
    int columns = 1;
    int cells = 1; ///< the last row may be part of one
    int cellWidth = 1;
    int cellHeight = 1;
    bool loops = false; ///< after the last cell comes the first

    /// @param number below cells
    [[nodiscard]] SheetCell cell(int number) const
    {
        return {number % columns * cellWidth, number / columns * cellHeight, cellWidth, cellHeight};
    }
};

/// Calls visit(SheetCell) for all whole cells of a picture, on all threads.
template <class Visit>
void forSheetCells(int width, int height, int cellWidth, int cellHeight, const Visit& visit)
{
    const SheetGrid grid{width / cellWidth, width / cellWidth * (height / cellHeight), cellWidth, cellHeight};
    parallelFor(
        static_cast<std::size_t>(grid.cells), [&](std::size_t cell) { visit(grid.cell(static_cast<int>(cell))); });
}

/// A pixel as it is shown: no channel above 1.
[[nodiscard]] inline glm::vec4 shown(const glm::vec4& colour)
{
    return glm::min(colour, glm::vec4(1.0F));
}

/// A colour between the pixels of a cell, bilinear, as it is shown; beyond the outermost it is theirs.
/// @param u,v pixels from the centre of the cell's first
[[nodiscard]] inline glm::vec4 shownBetween(const Image& sheet, const SheetCell& cell, float u, float v)
{
    const float x = std::clamp(u, 0.0F, static_cast<float>(cell.width - 1));
    const float y = std::clamp(v, 0.0F, static_cast<float>(cell.height - 1));
    const int left = static_cast<int>(x);
    const int top = static_cast<int>(y);
    const int right = std::min(left + 1, cell.width - 1);
    const int bottom = std::min(top + 1, cell.height - 1);
    const auto at = [&](int i, int j) { return shown(sheet.at(cell.left + i, cell.top + j)); };
    const float across = x - static_cast<float>(left);
    const float down = y - static_cast<float>(top);
    return glm::mix(
        glm::mix(at(left, top), at(right, top), across), glm::mix(at(left, bottom), at(right, bottom), across), down);
}

} // namespace fumage
