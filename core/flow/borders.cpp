#include "core/flow/borders.h"

#include <algorithm>
#include <array>

namespace fumage {

namespace {

/// Calls fill(axis, isHigh, border, ghost cell, cell within) for all ghosts beside plane k. Ghosts along x come first and are part of the rows that
/// those along y are made from, and so on: corners are filled last.
template <class Fill>
void forGhosts(const AirCells& cells, int k, const Fill& fill)
{
    const glm::ivec3 n = cells.grid.cells;
    for (int j = 0; j < n.y; ++j) {
        fill(0, false, cells.borders.low[0], glm::ivec3(-1, j, k), glm::ivec3(0, j, k));
        fill(0, true, cells.borders.high[0], glm::ivec3(n.x, j, k), glm::ivec3(n.x - 1, j, k));
    }
    for (int i = -1; i <= n.x; ++i) {
        fill(1, false, cells.borders.low[1], glm::ivec3(i, -1, k), glm::ivec3(i, 0, k));
        fill(1, true, cells.borders.high[1], glm::ivec3(i, n.y, k), glm::ivec3(i, n.y - 1, k));
    }
    const auto plane = [&](bool isHigh, Border border, int ghost) {
        for (int j = -1; j <= n.y; ++j) {
            for (int i = -1; i <= n.x; ++i) {
                fill(2, isHigh, border, glm::ivec3(i, j, ghost), glm::ivec3(i, j, k));
            }
        }
    };
    if (k == 0) {
        plane(false, cells.borders.low[2], -1);
    }
    if (k == n.z - 1) {
        plane(true, cells.borders.high[2], n.z);
    }
}

} // namespace

void fillQuadGhosts(const AirCells& cells, AirColumn& quads, const glm::vec3& outsideWind, int k)
{
    const std::array outside{outsideWind.x, outsideWind.y, outsideWind.z};
    const auto at = [&](const glm::ivec3& cell) { return quads.data() + cells.quad.at(cell.x, cell.y, cell.z); };
    forGhosts(cells, k, [&](int axis, bool isHigh, Border border, const glm::ivec3& ghost, const glm::ivec3& within) {
        float* to = at(ghost);
        const float* from = at(within);
        std::copy_n(from, 4, to);
        if (border == Border::Solid) {
            to[axis] = -from[axis];
            return;
        }
        const float inwards = isHigh ? -1.0F : 1.0F;
        const float wind = outside[static_cast<std::size_t>(axis)];
        if (inwards * (from[axis] + wind) > 0.0F) {
            std::copy_n(outside.data(), 3, to);
            to[axis] = inwards * std::max(inwards * from[axis], inwards * wind);
            to[3] = 0.0F;
        }
    });
}

void fillVelocityGhosts(const AirCells& cells, AirVectors& velocity, int k)
{
    const std::array<float*, 3> column{velocity.x.data(), velocity.y.data(), velocity.z.data()};
    forGhosts(cells, k, [&](int axis, bool /*isHigh*/, Border border, const glm::ivec3& ghost, const glm::ivec3& within) {
        const std::size_t to = cells.column.at(ghost.x, ghost.y, ghost.z);
        const std::size_t from = cells.column.at(within.x, within.y, within.z);
        for (std::size_t each = 0; each < 3; ++each) {
            const bool mirrored = border == Border::Solid && static_cast<int>(each) == axis;
            column[each][to] = mirrored ? -column[each][from] : column[each][from];
        }
    });
}

void fillEvenGhosts(const AirCells& cells, AirColumn& column, int k)
{
    forGhosts(cells, k, [&](int /*axis*/, bool /*isHigh*/, Border /*border*/, const glm::ivec3& ghost, const glm::ivec3& within) {
        column[cells.column.at(ghost.x, ghost.y, ghost.z)] = column[cells.column.at(within.x, within.y, within.z)];
    });
}

void fillPressureGhosts(const AirCells& cells, AirColumn& pressure, int k)
{
    forGhosts(cells, k, [&](int /*axis*/, bool /*isHigh*/, Border border, const glm::ivec3& ghost, const glm::ivec3& within) {
        const float inside = pressure[cells.column.at(within.x, within.y, within.z)];
        pressure[cells.column.at(ghost.x, ghost.y, ghost.z)] = border == Border::Solid ? inside : -inside;
    });
}

} // namespace fumage
