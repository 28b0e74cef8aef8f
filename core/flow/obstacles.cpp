#include "core/flow/obstacles.h"

#include "core/flow/boundaries.h"
#include "core/flow/planes.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <glm/common.hpp>

namespace fumage {

namespace {

/// Fastest that a wall pushes the air, m/s: as fast as air may be.
constexpr float kMaxWallSpeed = 2000.0F;

constexpr std::array kSteps{glm::ivec3(1, 0, 0), glm::ivec3(0, 1, 0), glm::ivec3(0, 0, 1)};

/// Lets air through the faces that have air on both sides; those of ghosts too, which nodes on the border take their
/// means from.
void openFaces(AirCells& cells)
{
    const glm::ivec3 n = cells.grid.cells;
    cells.open.resize(cells.column.size);
    const auto row = [&](auto& column, int j, int k) {
        return column.data() + cells.column.at(-1, std::max(j, -1), std::max(k, -1));
    };
    forPlanes(cells.column, -1, n.z + 1, 1, [&](int k) {
        for (int j = -1; j <= n.y; ++j) {
            const float* fluid = row(cells.fluid, j, k);
            const float* before = row(cells.fluid, j - 1, k);
            const float* under = row(cells.fluid, j, k - 1);
            float* x = row(cells.open.x, j, k);
            float* y = row(cells.open.y, j, k);
            float* z = row(cells.open.z, j, k);
            for (int i = 0; i < n.x + 2; ++i) {
                x[i] = std::min(fluid[i], fluid[std::max(0, i - 1)]);
                y[i] = std::min(fluid[i], before[i]);
                z[i] = std::min(fluid[i], under[i]);
            }
        }
    });
}

/// Cells of a grid from low up to, and without, high.
struct CellBox {
    glm::ivec3 low{0};
    glm::ivec3 high{0};
};

/// Calls visit(cell) for all cells of a box, those along x first.
template <class Visit>
void forCellsOf(const CellBox& box, const Visit& visit)
{
    forCells(box.high - box.low, [&](const glm::ivec3& within) { visit(box.low + within); });
}

/// All cells that solids may lie in, and those beside them.
CellBox cellsAround(const AirGrid& grid, std::span<const Solid> solids)
{
    CellBox box{grid.cells, glm::ivec3(0)};
    const glm::vec3 last(grid.cells);
    for (const Solid& solid : solids) {
        const glm::vec3 half =
            0.5F * (solid.shape == SolidShape::Sphere ? glm::vec3(solid.size.x) : glm::abs(solid.size));
        const auto cellOf = [&](const glm::vec3& place, float beside) {
            return glm::ivec3(
                glm::clamp(glm::floor((place - grid.corner) / grid.cell) + beside, glm::vec3(0.0F), last));
        };
        box.low = glm::min(box.low, cellOf(solid.centre - half, -2.0F));
        box.high = glm::max(box.high, cellOf(solid.centre + half, 3.0F));
    }
    box.high = glm::max(box.low, box.high);
    return box;
}

/// Finds the cells whose centres lie in no solid.
/// @return how many lie in one
std::int64_t findFluid(const AirCells& cells, std::span<const Solid> solids, const CellBox& around, AirColumn& fluid)
{
    const glm::ivec3 n = cells.grid.cells;
    fluid.assign(cells.column.size, 0.0F);
    forPlanes(cells.column, 0, n.z, 1, [&](int k) {
        for (int j = 0; j < n.y; ++j) {
            std::fill_n(fluid.data() + cells.column.at(0, j, k), n.x, 1.0F);
        }
    });
    std::int64_t inside = 0;
    forCellsOf(around, [&](const glm::ivec3& c) {
        const glm::vec3 centre = cells.grid.centre(c);
        if (std::any_of(solids.begin(), solids.end(), [&](const Solid& solid) { return solid.contains(centre); })) {
            fluid[cells.column.at(c.x, c.y, c.z)] = 0.0F;
            ++inside;
        }
    });
    return inside;
}

/// Lists the cells of obstacles that have air beside them, and counts the walls that air touches.
void findHalo(AirCells& cells, const CellBox& around)
{
    const glm::ivec3 n = cells.grid.cells;
    const auto fluid = [&](const glm::ivec3& c) { return cells.fluid[cells.column.at(c.x, c.y, c.z)] != 0.0F; };
    cells.touching.assign(cells.column.size, 0.0F);
    forCellsOf(around, [&](const glm::ivec3& c) {
        AirCells::Halo skin{c, 0};
        for (unsigned side = 0; side < 6; ++side) {
            const glm::ivec3 step = kSteps[side / 2];
            const glm::ivec3 beside = side % 2 == 0 ? c - step : c + step;
            const bool outside =
                glm::any(glm::lessThan(beside, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(beside, n));
            if (outside || fluid(c) == fluid(beside)) {
                continue;
            }
            if (fluid(c)) {
                cells.touching[cells.column.at(c.x, c.y, c.z)] += 1.0F;
            } else {
                skin.sides |= 1U << side;
            }
        }
        if (skin.sides != 0) {
            cells.skin.push_back(skin);
        }
    });
}

/// The solid of a closed face: the first that one of its two cells lies in.
const Solid* solidAt(std::span<const Solid> solids, const glm::vec3& one, const glm::vec3& other)
{
    const auto found = std::find_if(
        solids.begin(), solids.end(), [&](const Solid& solid) { return solid.contains(one) || solid.contains(other); });
    return found == solids.end() ? nullptr : &*found;
}

/// Finds how fast closed faces move; those of ghosts too.
void moveWalls(AirCells& cells, std::span<const Solid> solids, const CellBox& around)
{
    const auto moving = std::find_if(solids.begin(), solids.end(), [](const Solid& solid) { return solid.moves(); });
    cells.wallVelocity = moving == solids.end()
        ? glm::vec3(0.0F)
        : glm::clamp(moving->velocity, glm::vec3(-kMaxWallSpeed), glm::vec3(kMaxWallSpeed));
    if (moving == solids.end()) {
        cells.wall.clear();
        return;
    }
    cells.wall.resize(cells.column.size);
    const glm::ivec3 last = cells.grid.cells - 1;
    const std::array open{&cells.open.x, &cells.open.y, &cells.open.z};
    const std::array wall{&cells.wall.x, &cells.wall.y, &cells.wall.z};
    // Ghosts are beside cells of the box where those are at the border.
    forCellsOf({around.low - 1, around.high + 1}, [&](const glm::ivec3& c) {
        const std::size_t at = cells.column.at(c.x, c.y, c.z);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if ((*open[axis])[at] != 0.0F) {
                continue;
            }
            // A ghost is as the cell beside it.
            const auto centreOf = [&](const glm::ivec3& of) {
                return cells.grid.centre(glm::clamp(of, glm::ivec3(0), last));
            };
            const glm::vec3 face = cells.grid.centre(c) - 0.5F * cells.grid.cell * glm::vec3(kSteps[axis]);
            if (const Solid* solid = solidAt(solids, centreOf(c), centreOf(c - kSteps[axis]))) {
                const float speed = solid->velocityAt(face)[static_cast<int>(axis)];
                (*wall[axis])[at] = std::clamp(speed, -kMaxWallSpeed, kMaxWallSpeed);
            }
        }
    });
}

} // namespace

SolidsPlaced placeSolids(AirCells& cells, std::span<const Solid> solids)
{
    AirColumn& fluid = cells.fluidBefore; // as it will be, until they change places
    const CellBox around = cellsAround(cells.grid, solids);
    const std::int64_t inside = solids.empty() ? 0 : findFluid(cells, solids, around, fluid);
    const glm::i64vec3 n(cells.grid.cells);
    if (inside == n.x * n.y * n.z) {
        return SolidsPlaced::Nowhere;
    }
    if (inside == 0) {
        const bool hadSolids = cells.hasObstacles();
        cells.skin.clear();
        cells.fluid.clear();
        cells.open.clear();
        cells.touching.clear();
        cells.wall.clear();
        return hadSolids ? SolidsPlaced::Elsewhere : SolidsPlaced::AsBefore;
    }
    for (int k = 0; k < cells.grid.cells.z; ++k) {
        fillEvenGhosts(cells, fluid, k);
    }
    const bool isAsBefore = fluid == cells.fluid;
    if (!isAsBefore) {
        std::swap(fluid, cells.fluid);
        cells.skin.clear();
        openFaces(cells);
        findHalo(cells, around);
    }
    moveWalls(cells, solids, around);
    return isAsBefore ? SolidsPlaced::AsBefore : SolidsPlaced::Elsewhere;
}

void fillHalo(const AirCells& cells, AirColumn& quads)
{
    const std::array strides{std::size_t{4}, cells.quad.row, cells.quad.plane};
    const std::array faces{std::size_t{1}, cells.column.row, cells.column.plane};
    const std::array walls{&cells.wall.x, &cells.wall.y, &cells.wall.z};
    for (const AirCells::Halo& skin : cells.skin) {
        float* to = quads.data() + cells.quad.at(skin.cell.x, skin.cell.y, skin.cell.z);
        std::array<float, 4> sum{};
        float count = 0.0F;
        for (unsigned side = 0; side < 6; ++side) {
            if ((skin.sides >> side & 1U) == 0) {
                continue;
            }
            const float* from = side % 2 == 0 ? to - strides[side / 2] : to + strides[side / 2];
            for (unsigned part = 0; part < 4; ++part) {
                sum[part] += part == side / 2 ? -from[part] : from[part];
            }
            if (cells.hasMovingWalls()) {
                const std::size_t face =
                    cells.column.at(skin.cell.x, skin.cell.y, skin.cell.z) + (side % 2 == 0 ? 0 : faces[side / 2]);
                sum[side / 2] += 2.0F * (*walls[side / 2])[face];
            }
            count += 1.0F;
        }
        std::transform(sum.begin(), sum.end(), to, [&](float each) { return each / count; });
    }
}

} // namespace fumage
