#include "core/flow/heat_budget.h"

#include <algorithm>
#include <array>

namespace fumage {

namespace {

/// Adds up what some numbers of a plane's cells of air come to, in as many sums side by side as make the order that of no instruction set.
/// @param numberOf row to what gives the number of its cell i
template <class NumberOf>
double sumOfPlane(const AirCells& cells, int k, const NumberOf& numberOf)
{
    std::array<double, kAirLanes> sums{};
    const auto n = static_cast<std::size_t>(cells.grid.cells.x);
    for (int j = 0; j < cells.grid.cells.y; ++j) {
        const float* fluid = cells.hasObstacles() ? cells.fluid.data() + cells.column.at(0, j, k) : nullptr;
        const auto number = numberOf(j);
        for (std::size_t i = 0; i < n; ++i) {
            const double here = static_cast<double>(number(i));
            sums[i % kAirLanes] += fluid == nullptr || fluid[i] != 0.0F ? here : 0.0;
        }
    }
    double sum = 0.0;
    for (const double each : sums) {
        sum += each;
    }
    return sum;
}

/// The heat of the first guess, a quad apart, in a row of cells.
const float* guessedHeat(const AirCells& cells, int j, int k)
{
    return cells.guess.data() + cells.quad.at(0, j, k) + 3;
}

/// Heat that leaves a cell through a side of the box.
/// @param sign of the way out along the axis
double outThrough(const AirCells& cells, const glm::ivec3& cell, int axis, float sign, float cellsPerSpeed)
{
    const std::size_t at = cells.quad.at(cell.x, cell.y, cell.z);
    const float share = std::clamp(sign * cells.carrier[at + static_cast<std::size_t>(axis)] * cellsPerSpeed, 0.0F, 1.0F);
    return static_cast<double>(share * cells.air[at + 3]);
}

double outOfPlane(const AirCells& cells, float dt, int k)
{
    const glm::ivec3 n = cells.grid.cells;
    const float cellsPerSpeed = dt / cells.grid.cell;
    double sum = 0.0;
    const auto side = [&](int axis, bool isHigh, const glm::ivec3& cell) {
        const auto each = static_cast<std::size_t>(axis);
        if ((isHigh ? cells.borders.high[each] : cells.borders.low[each]) == Border::Open) {
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
    plane.before = sumOfPlane(cells, k, [&](int j) {
        return [row = cells.air.data() + cells.quad.at(0, j, k) + 3](std::size_t i) { return row[4 * i]; };
    });
    plane.out = outOfPlane(cells, dt, k);
}

void HeatBudget::after(const AirCells& cells, int k)
{
    Plane& plane = m_planes[static_cast<std::size_t>(k)];
    const auto sumOf = [&](const auto& part) {
        return sumOfPlane(cells, k, [&, part](int j) {
            return [heat = cells.heat.data() + cells.column.at(0, j, k), guess = guessedHeat(cells, j, k), part](std::size_t i) { return part(heat[i], guess[4 * i]); };
        });
    };
    plane.after = sumOf([](float heat, float /*guess*/) { return heat; });
    plane.more = sumOf([](float heat, float guess) { return std::max(0.0F, guess - heat); });
    plane.less = sumOf([](float heat, float guess) { return std::max(0.0F, heat - guess); });
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
    const auto share = [](double part, double whole) { return part > 0.0 && whole > 0.0 ? static_cast<float>(std::min(1.0, part / whole)) : 0.0F; };
    return {share(lacking, more), share(-lacking, less)};
}

void HeatBudget::correct(AirCells& cells, const Correction& correction, int k)
{
    const auto n = static_cast<std::size_t>(cells.grid.cells.x);
    for (int j = 0; j < cells.grid.cells.y; ++j) {
        float* heat = cells.heat.data() + cells.column.at(0, j, k);
        const float* guess = guessedHeat(cells, j, k);
        for (std::size_t i = 0; i < n; ++i) {
            const float more = guess[4 * i] - heat[i];
            heat[i] += correction.up * std::max(0.0F, more) + correction.down * std::min(0.0F, more);
        }
    }
}

} // namespace fumage
