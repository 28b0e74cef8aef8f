#include "core/flow/obstacles.h"

#include "core/flow/boundaries.h"

#include <algorithm>
#include <array>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace fumage {

namespace {

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

} // namespace

bool Solid::contains(const glm::vec3& place) const
{
    const glm::vec3 away = place - centre;
    if (shape == SolidShape::Sphere) {
        return glm::dot(away, away) < 0.25F * size.x * size.x;
    }
    return glm::all(glm::lessThan(glm::abs(away), 0.5F * size));
}

bool placeSolids(AirCells& cells, std::span<const Solid> solids)
{
    bool anyAir = false;
    bool anySolid = false;
    AirColumn fluid(cells.column.size, 0.0F);
    forCells(cells.grid.cells, [&](const glm::ivec3& c) {
        const glm::vec3 centre = cells.grid.centre(c);
        const bool inside =
            std::any_of(solids.begin(), solids.end(), [&](const Solid& solid) { return solid.contains(centre); });
        fluid[cells.column.at(c.x, c.y, c.z)] = inside ? 0.0F : 1.0F;
        anyAir = anyAir || !inside;
        anySolid = anySolid || inside;
    });
    if (!anyAir) {
        return false;
    }
    cells.skin.clear();
    cells.fluid.clear();
    cells.open = {};
    cells.touching.clear();
    if (anySolid) {
        cells.fluid = std::move(fluid);
        for (int k = 0; k < cells.grid.cells.z; ++k) {
            fillEvenGhosts(cells, cells.fluid, k);
        }
        openFaces(cells);
        findHalo(cells);
    }
    return true;
}

void fillHalo(const AirCells& cells, AirColumn& quads)
{
    const std::array strides{std::size_t{4}, cells.quad.row, cells.quad.plane};
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
            count += 1.0F;
        }
        std::transform(sum.begin(), sum.end(), to, [&](float each) { return each / count; });
    }
}

} // namespace fumage
