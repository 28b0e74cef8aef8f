#include "core/flow/heat_budget.h"

#include "core/flow/heat_kernel.h"

#include <algorithm>

namespace fumage {

namespace {

/// Heat that leaves a cell through a side of the box.
/// @param sign of the way out along the axis
double outThrough(const AirCells& cells, const glm::ivec3& cell, int axis, float sign, float cellsPerSpeed)
{
    const std::size_t at = cells.quad.at(cell.x, cell.y, cell.z);
    const float share =
        std::clamp(sign * cells.carrier[at + static_cast<std::size_t>(axis)] * cellsPerSpeed, 0.0F, 1.0F);
    return static_cast<double>(share * cells.air[at + 3]);
}

double outOfPlane(const AirCells& cells, float dt, int k)
{
    const glm::ivec3 n = cells.grid.cells;
    const float cellsPerSpeed = dt / cells.grid.cell;
    double sum = 0.0;
    const auto side = [&](int axis, bool isHigh, const glm::ivec3& cell) {
        const auto each = static_cast<std::size_t>(axis);
        if ((isHigh ? cells.boundaries.high[each] : cells.boundaries.low[each]) == Boundary::Open) {
            sum += outThrough(cells, cell, axis, isHigh ? 1.0F : -1.0F, cellsPerSpeed);
        }
    };
    for (int j = 0; j < n.y; ++j) {
        side(0, false, {0, j, k});
        side(0, true, {n.x - 1, j, k});
    }
    for (int i = 0; i < n.x; ++i) {
        side(1, false, {i, 0, k});
        side(1, true, {i, n.y - 1, k});
        for (int j = 0; j < n.y && (k == 0 || k == n.z - 1); ++j) {
            side(2, k != 0, {i, j, k});
        }
    }
    return sum;
}

} // namespace

void HeatBudget::before(const AirCells& cells, float dt, int k)
{
    Plane& plane = m_planes[static_cast<std::size_t>(k)];
    plane.before = heatOfAir(cells, k);
    plane.out = outOfPlane(cells, dt, k);
}

void HeatBudget::after(const AirCells& cells, int k)
{
    Plane& plane = m_planes[static_cast<std::size_t>(k)];
    const CarriedHeat carried = carriedHeat(cells, k);
    plane.after = carried.all;
    plane.more = carried.more;
    plane.less = carried.less;
}

HeatBudget::Correction HeatBudget::correction() const
{
    double lacking = 0.0;
    double more = 0.0;
    double less = 0.0;
    for (const Plane& plane : m_planes) {
        lacking += plane.before - plane.out - plane.after;
        more += plane.more;
        less += plane.less;
    }
    const auto share = [](double part, double whole) {
        return part > 0.0 && whole > 0.0 ? static_cast<float>(std::min(1.0, part / whole)) : 0.0F;
    };
    return {share(lacking, more), share(-lacking, less)};
}

void HeatBudget::correct(AirCells& cells, const Correction& correction, int k)
{
    if (correction.up != 0.0F || correction.down != 0.0F) {
        correctHeat(cells, correction.up, correction.down, k);
    }
}

} // namespace fumage
