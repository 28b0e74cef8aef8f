#include "core/flow/obstacles.h"

#include "core/flow/boundaries.h"

#include <algorithm>
#include <array>

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
    const auto fluid = [&](const glm::ivec3& c) { return cells.fluid[cells.column.at(c.x, c.y, c.z)]; };
    cells.open.resize(cells.column.size);
    const std::array columns{&cells.open.x, &cells.open.y, &cells.open.z};
    forCells(n + 2, [&](const glm::ivec3& ghost) {
        const glm::ivec3 c = ghost - 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const glm::ivec3 below = glm::max(c - kSteps[axis], glm::ivec3(-1));
            (*columns[axis])[cells.column.at(c.x, c.y, c.z)] = std::min(fluid(c), fluid(below));
        }
    });
}

/// Lists the cells of obstacles that have air beside them, and counts the walls that air touches.
void findHalo(AirCells& cells)
{
    const glm::ivec3 n = cells.grid.cells;
    const auto fluid = [&](const glm::ivec3& c) { return cells.fluid[cells.column.at(c.x, c.y, c.z)] != 0.0F; };
    cells.touching.assign(cells.column.size, 0.0F);
    forCells(n, [&](const glm::ivec3& c) {
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
    cells.wall.resize(cells.column.size);
    const glm::ivec3 last = cells.grid.cells - 1;
    const std::array open{&cells.open.x, &cells.open.y, &cells.open.z};
    const std::array wall{&cells.wall.x, &cells.wall.y, &cells.wall.z};
    forCells(cells.grid.cells + 2, [&](const glm::ivec3& ghost) {
        const glm::ivec3 c = ghost - 1;
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
    bool anyAir = false;
    bool anySolid = false;
    AirColumn& fluid = cells.fluidBefore; // as it will be, until they change places
    if (!solids.empty()) {
        fluid.assign(cells.column.size, 0.0F);
        forCells(cells.grid.cells, [&](const glm::ivec3& c) {
            const glm::vec3 centre = cells.grid.centre(c);
            const bool inside =
                std::any_of(solids.begin(), solids.end(), [&](const Solid& solid) { return solid.contains(centre); });
            fluid[cells.column.at(c.x, c.y, c.z)] = inside ? 0.0F : 1.0F;
            anyAir = anyAir || !inside;
            anySolid = anySolid || inside;
        });
        if (!anyAir) {
            return SolidsPlaced::Nowhere;
        }
    }
    if (!anySolid) {
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
