#pragma once

#include "core/base/hash.h"
#include "core/flow/solver.h"

#include <cmath>

namespace fumage::tests {

/// A box with its ground at y = 0, x and z around 0.
inline AirGrid boxOf(const glm::ivec3& cells, float height)
{
    const float cell = height / static_cast<float>(cells.y);
    const glm::vec3 size = cell * glm::vec3(cells);
    return {cells, cell, {-0.5F * size.x, 0.0F, -0.5F * size.z}};
}

inline AirBoundaries closedBox()
{
    AirBoundaries boundaries;
    boundaries.low = {Boundary::Solid, Boundary::Solid, Boundary::Solid};
    boundaries.high = boundaries.low;
    return boundaries;
}

inline AirBoundaries onGround()
{
    AirBoundaries boundaries;
    boundaries.low[1] = Boundary::Solid;
    return boundaries;
}

/// A step of warm air without a source.
inline AirStep plainStep()
{
    AirStep step;
    step.dt = 1.0F / 30.0F;
    return step;
}

/// A step with a round source on the ground whose rim is even.
inline AirStep plumeStep(const AirGrid& grid, float radius)
{
    AirStep step = plainStep();
    step.buoyancy = 3.0F;
    AirSource& source = step.source;
    source.acts = true;
    source.heat = 1.0F;
    source.reach = glm::vec2(radius);
    source.depth = 0.5F * radius;
    source.softness = 2.0F * grid.cell;
    source.speed = 0.5F;
    source.relaxation = 0.5F;
    source.first = {0, 0, 0};
    source.last = {(grid.cells.x + 15) / 16 * 16, grid.cells.y / 4, grid.cells.z};
    return step;
}

/// Lets the rim of a source wander, and its noise go on from step to step.
inline void makeRagged(AirStep& step, float raggedness, float time)
{
    step.source.raggedness = raggedness;
    float weight = 87.0F * 0x1p-31F;
    float frequency = 0.6F / step.source.reach.x;
    std::uint32_t seed = 5;
    for (AirOctave& octave : step.source.rim) {
        const float slice = std::floor(3.0F * time);
        const float turn = 1.5707963F * (3.0F * time - slice);
        octave.frequency = frequency;
        octave.shift = {0.3F, 0.1F, 0.7F};
        octave.slices.key = {
            keyOf(seed, static_cast<std::uint64_t>(slice)), keyOf(seed, static_cast<std::uint64_t>(slice) + 1)};
        octave.slices.weight = {weight * std::cos(turn), weight * std::sin(turn)};
        weight *= 0.5F;
        frequency *= 2.0F;
        ++seed;
    }
}

/// Root mean square of the divergence that is left, over that of the velocity's gradient; away from the source.
/// @param from lowest row of cells that counts
inline double shareOfDivergence(const AirSolver& air, int from)
{
    const glm::ivec3 n = air.grid().cells;
    double divergence = 0.0;
    double gradient = 0.0;
    const auto inside = [&](const glm::ivec3& c) {
        return c.x > 0 && c.y > 0 && c.z > 0 && c.x + 1 < n.x && c.y + 1 < n.y && c.z + 1 < n.z;
    };
    forCells(n, [&](const glm::ivec3& c) {
        if (c.y < from || air.isSolid(c)) {
            return;
        }
        const double left = static_cast<double>(air.divergenceAt(c));
        divergence += left * left;
        if (!inside(c)) {
            return;
        }
        for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 way(0);
            way[axis] = 1;
            const glm::vec3 slope = glm::vec3(air.at(c + way) - air.at(c - way)) / (2.0F * air.grid().cell);
            gradient += static_cast<double>(slope.x * slope.x + slope.y * slope.y + slope.z * slope.z);
        }
    });
    return std::sqrt(divergence / gradient);
}

} // namespace fumage::tests
