#include "core/flow/boundaries.h"

#include <algorithm>
#include <array>

namespace fumage {

namespace {

/// A row of ghosts beside the box, or a single one.
struct GhostRow {
    int axis; ///< across the side
    bool isHigh;
    Boundary border;
    glm::ivec3 ghost; ///< the first, along x
    glm::ivec3 within; ///< the cell in the box beside it
    std::size_t count;

    /// Sign of the way in along the axis.
    [[nodiscard]] float inwards() const { return isHigh ? -1.0F : 1.0F; }
    /// 1, or -1 where what is mirrored changes its sign.
    [[nodiscard]] float signAt(Boundary mirror) const { return border == mirror ? -1.0F : 1.0F; }
};

/// Calls fill(row) for all ghosts beside plane k. Ghosts along x come first and are part of the rows that those along y
/// are made from, and so on: corners are filled last.
template <class Fill>
void forGhosts(const AirCells& cells, int k, const Fill& fill)
{
    const glm::ivec3 n = cells.grid.cells;
    const AirBoundaries& boundaries = cells.boundaries;
    for (int j = 0; j < n.y; ++j) {
        fill(GhostRow{0, false, boundaries.low[0], {-1, j, k}, {0, j, k}, 1});
        fill(GhostRow{0, true, boundaries.high[0], {n.x, j, k}, {n.x - 1, j, k}, 1});
    }
    const auto row = static_cast<std::size_t>(n.x) + 2;
    fill(GhostRow{1, false, boundaries.low[1], {-1, -1, k}, {-1, 0, k}, row});
    fill(GhostRow{1, true, boundaries.high[1], {-1, n.y, k}, {-1, n.y - 1, k}, row});
    for (int j = -1; j <= n.y && k == 0; ++j) {
        fill(GhostRow{2, false, boundaries.low[2], {-1, j, -1}, {-1, j, 0}, row});
    }
    for (int j = -1; j <= n.y && k == n.z - 1; ++j) {
        fill(GhostRow{2, true, boundaries.high[2], {-1, j, n.z}, {-1, j, n.z - 1}, row});
    }
}

std::size_t placeOf(const ColumnLayout& layout, const glm::ivec3& cell)
{
    return layout.at(cell.x, cell.y, cell.z);
}

/// Each ghost is what is beside it, times a sign.
void fillRow(const AirCells& cells, AirColumn& column, const GhostRow& row, float sign)
{
    const float* from = column.data() + placeOf(cells.column, row.within);
    float* to = column.data() + placeOf(cells.column, row.ghost);
    for (std::size_t i = 0; i < row.count; ++i) {
        to[i] = sign * from[i];
    }
}

/// What comes in through an open border, or goes out.
void fillOpenRow(const GhostRow& row, const std::array<float, 4>& outside, const float* from, float* to)
{
    const auto axis = static_cast<std::size_t>(row.axis);
    const float inwards = row.inwards();
    const float wind = inwards * outside[axis];
    for (std::size_t quad = 0; quad < 4 * row.count; quad += 4) {
        const float across = from[quad + axis];
        const bool comes = inwards * across + wind > 0.0F;
        std::copy_n(comes ? outside.data() : from + quad, 4, to + quad);
        to[quad + axis] = comes ? inwards * std::max(inwards * across, wind) : across;
    }
}

void fillSolidRow(const GhostRow& row, const float* from, float* to)
{
    std::copy_n(from, 4 * row.count, to);
    for (std::size_t at = static_cast<std::size_t>(row.axis); at < 4 * row.count; at += 4) {
        to[at] = -from[at];
    }
}

} // namespace

void fillQuadGhosts(const AirCells& cells, AirColumn& quads, const glm::vec3& wind, int k)
{
    const std::array outside{wind.x, wind.y, wind.z, 0.0F};
    const auto at = [&](const glm::ivec3& cell) { return quads.data() + cells.quad.at(cell.x, cell.y, cell.z); };
    forGhosts(cells, k, [&](const GhostRow& row) {
        if (row.border == Boundary::Solid) {
            fillSolidRow(row, at(row.within), at(row.ghost));
        } else {
            fillOpenRow(row, outside, at(row.within), at(row.ghost));
        }
    });
}

void fillVelocityGhosts(const AirCells& cells, AirVectors& velocity, int k)
{
    const std::array column{&velocity.x, &velocity.y, &velocity.z};
    forGhosts(cells, k, [&](const GhostRow& row) {
        for (std::size_t each = 0; each < column.size(); ++each) {
            fillRow(cells, *column[each], row, static_cast<int>(each) == row.axis ? row.signAt(Boundary::Solid) : 1.0F);
        }
    });
}

void slowInflow(AirCells& cells, const glm::vec3& wind, float dt, int k)
{
    const std::array velocity{&cells.forced.x, &cells.forced.y, &cells.forced.z};
    const float halfStep = 0.5F * dt / cells.grid.cell;
    forGhosts(cells, k, [&](const GhostRow& row) {
        if (row.border != Boundary::Open) {
            return;
        }
        const auto axis = static_cast<std::size_t>(row.axis);
        const float outside = std::max(0.0F, row.inwards() * wind[row.axis]);
        // The carrying velocity has no ripple from cell to cell.
        const float* carrier = cells.carrier.data() + cells.quad.at(row.within.x, row.within.y, row.within.z) + axis;
        float* each = velocity[axis]->data() + placeOf(cells.column, row.within);
        for (std::size_t i = 0; i < row.count; ++i) {
            const float faster = std::max(0.0F, row.inwards() * carrier[4 * i] - outside);
            each[i] -= row.inwards() * (faster - faster / (1.0F + halfStep * faster));
        }
    });
}

void fillEvenGhosts(const AirCells& cells, AirColumn& column, int k)
{
    forGhosts(cells, k, [&](const GhostRow& row) { fillRow(cells, column, row, 1.0F); });
}

void fillPressureGhosts(const AirCells& cells, AirColumn& pressure, int k)
{
    forGhosts(cells, k, [&](const GhostRow& row) { fillRow(cells, pressure, row, row.signAt(Boundary::Open)); });
}

} // namespace fumage
