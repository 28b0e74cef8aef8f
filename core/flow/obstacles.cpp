#include "core/flow/obstacles.h"

#include "core/flow/boundaries.h"
#include "core/flow/planes.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>

#include <glm/common.hpp>

namespace fumage {

namespace {

/// Fastest that a wall pushes the air, m/s: as fast as air may be.
constexpr float kMaxWallSpeed = 2000.0F;

constexpr std::array kSteps{glm::ivec3(1, 0, 0), glm::ivec3(0, 1, 0), glm::ivec3(0, 0, 1)};

/// The lower faces of the cells of a box and of those around it, ghosts among them.
CellBox facesOf(const CellBox& box)
{
    return {box.low - 1, box.high + 1};
}

CellBox unionOf(const CellBox& one, const CellBox& other)
{
    return {glm::min(one.low, other.low), glm::max(one.high, other.high)};
}

/// Makes the numbers of a box 0.
void clear(const ColumnLayout& layout, const CellBox& box, AirColumn& column)
{
    forRows(layout, box, [&](std::size_t at, int count) { std::fill_n(column.data() + at, count, 0.0F); });
}

/// Lets air through the faces that have air on both sides; those of ghosts too, which nodes on the border take their
/// means from.
void openFaces(AirCells& cells, const CellBox& box)
{
    const CellBox faces = facesOf(box);
    const auto row = [&](auto& column, int j, int k) {
        return column.data() + cells.column.at(0, std::max(j, -1), std::max(k, -1));
    };
    forPlanes(faces, [&](int k) {
        for (int j = faces.low.y; j < faces.high.y; ++j) {
            const float* fluid = row(cells.fluid, j, k);
            const float* before = row(cells.fluid, j - 1, k);
            const float* under = row(cells.fluid, j, k - 1);
            float* x = row(cells.open.x, j, k);
            float* y = row(cells.open.y, j, k);
            float* z = row(cells.open.z, j, k);
            for (int i = faces.low.x; i < faces.high.x; ++i) {
                x[i] = std::min(fluid[i], fluid[std::max(-1, i - 1)]);
                y[i] = std::min(fluid[i], before[i]);
                z[i] = std::min(fluid[i], under[i]);
            }
        }
    });
}

void removeSolids(AirCells& cells)
{
    cells.skin.clear();
    cells.fluid.clear();
    cells.open.clear();
    cells.touching.clear();
    cells.wall.clear();
}

/// Makes room for obstacles, of which none stands yet.
void makeRoom(AirCells& cells)
{
    const CellBox all{glm::ivec3(0), cells.grid.cells};
    cells.fluid.assign(cells.column.size, 0.0F);
    forRows(cells.column, facesOf(all),
        [&](std::size_t at, int count) { std::fill_n(cells.fluid.data() + at, count, 1.0F); });
    cells.open.resize(cells.column.size);
    openFaces(cells, all);
    cells.touching.assign(cells.column.size, 0.0F);
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

/// Finds the cells of a box whose centres lie in no solid.
/// @return how many lie in one
std::int64_t findFluid(AirCells& cells, std::span<const Solid> solids, const CellBox& box)
{
    cells.fluidAnew.resize(cells.column.size);
    std::int64_t inside = 0;
    forCellsOf(box, [&](const glm::ivec3& c) {
        const glm::vec3 centre = cells.grid.centre(c);
        const bool isWall =
            std::any_of(solids.begin(), solids.end(), [&](const Solid& solid) { return solid.contains(centre); });
        cells.fluidAnew[cells.column.at(c.x, c.y, c.z)] = isWall ? 0.0F : 1.0F;
        inside += isWall ? 1 : 0;
    });
    return inside;
}

/// Makes the cells walls or air as was found, and their ghosts.
/// @return whether any has changed
bool takeFluid(AirCells& cells)
{
    std::atomic<bool> hasChanged = false;
    forRows(cells.column, cells.changed, [&](std::size_t at, int count) {
        const float* anew = cells.fluidAnew.data() + at;
        float* fluid = cells.fluid.data() + at;
        if (!std::equal(anew, anew + count, fluid)) {
            std::copy_n(anew, count, fluid);
            hasChanged = true;
        }
    });
    const CellBox& box = cells.changed;
    const bool atBorder =
        glm::any(glm::equal(box.low, glm::ivec3(0))) || glm::any(glm::equal(box.high, cells.grid.cells));
    for (int k = box.low.z; hasChanged && atBorder && k < box.high.z; ++k) {
        fillEvenGhosts(cells, cells.fluid, k);
    }
    return hasChanged;
}

/// Lists the cells of obstacles that have air beside them, and counts the walls that air touches.
void findHalo(AirCells& cells)
{
    clear(cells.column, cells.changed, cells.touching);
    cells.skin.clear();
    const glm::ivec3 n = cells.grid.cells;
    const auto fluid = [&](const glm::ivec3& c) { return cells.fluid[cells.column.at(c.x, c.y, c.z)] != 0.0F; };
    forCellsOf(cells.around, [&](const glm::ivec3& c) {
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
void moveWalls(AirCells& cells, std::span<const Solid> solids)
{
    const auto moving = std::find_if(solids.begin(), solids.end(), [](const Solid& solid) { return solid.moves(); });
    cells.wallVelocity = moving == solids.end()
        ? glm::vec3(0.0F)
        : glm::clamp(moving->velocity, glm::vec3(-kMaxWallSpeed), glm::vec3(kMaxWallSpeed));
    if (moving == solids.end()) {
        cells.wall.clear();
        return;
    }
    const std::array open{&cells.open.x, &cells.open.y, &cells.open.z};
    const std::array wall{&cells.wall.x, &cells.wall.y, &cells.wall.z};
    if (!cells.hasMovingWalls()) {
        cells.wall.resize(cells.column.size);
    }
    for (AirColumn* column : wall) {
        clear(cells.column, facesOf(cells.changed), *column);
    }
    const glm::ivec3 last = cells.grid.cells - 1;
    forCellsOf(facesOf(cells.around), [&](const glm::ivec3& c) {
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
    const bool hadSolids = cells.hasObstacles();
    const CellBox around = cellsAround(cells.grid, solids);
    const CellBox changed = hadSolids ? unionOf(around, cells.around) : around;
    const std::int64_t inside = solids.empty() ? 0 : findFluid(cells, solids, changed);
    const glm::i64vec3 n(cells.grid.cells);
    if (inside == n.x * n.y * n.z) {
        return SolidsPlaced::Nowhere;
    }
    if (inside == 0) {
        removeSolids(cells);
        return hadSolids ? SolidsPlaced::Elsewhere : SolidsPlaced::AsBefore;
    }
    if (!hadSolids) {
        makeRoom(cells);
    }
    cells.around = around;
    cells.changed = changed;
    const bool isAsBefore = !takeFluid(cells);
    if (!isAsBefore) {
        openFaces(cells, changed);
        findHalo(cells);
    }
    moveWalls(cells, solids);
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
