#include "core/noise/row_positions.h"

#include "core/noise/lattice_noise.h"

#include <algorithm>
#include <numeric>

namespace fumage {

CellPlace placeInCells(int pixel, int size, int cells, CellBorders borders)
{
    // (pixel + 1/2) cells / size, counted in parts of 1 / (2 size).
    const int parts = 2 * size;
    const int place = (2 * pixel + 1) * cells + (borders == CellBorders::BetweenPoints ? size : 0);
    return {place / parts, static_cast<float>(static_cast<double>(place % parts) / parts)};
}

RowPositions rowPositions(int size, int cells, CellBorders borders)
{
    const std::size_t padded = roundUp(static_cast<std::size_t>(size), RowPositions::kBlock);
    const bool wholePixels = size % cells == 0;
    const std::size_t repeat =
        wholePixels ? std::min(padded, std::lcm(static_cast<std::size_t>(size / cells), RowPositions::kBlock)) : padded;
    RowPositions out;
    out.fraction.resize(repeat);
    out.lane.resize(repeat);
    out.uniform = true;
    const auto placeOf = [&](std::size_t i) {
        return placeInCells(std::min(static_cast<int>(i), size - 1), size, cells, borders);
    };
    for (std::size_t i = 0; i < padded; i += RowPositions::kBlock) {
        out.cell.push_back(placeOf(i).cell);
    }
    for (std::size_t i = 0; i < repeat; ++i) {
        const CellPlace place = placeOf(i);
        out.lane[i] = place.cell - out.cell[i / RowPositions::kBlock];
        out.uniform = out.uniform && out.lane[i] == 0;
        out.fraction[i] = place.fraction;
    }
    return out;
}

void weighByInterpolation(RowPositions& positions, Interpolation kind)
{
    positions.weight.resize(positions.fraction.size());
    std::transform(positions.fraction.begin(), positions.fraction.end(), positions.weight.begin(),
        [&](float f) { return interpolationWeight(kind, f); });
}

void weighBySquare(RowPositions& positions)
{
    positions.weight.resize(positions.fraction.size());
    std::transform(
        positions.fraction.begin(), positions.fraction.end(), positions.weight.begin(), [](float f) { return f * f; });
}

} // namespace fumage
