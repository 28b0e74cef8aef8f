#include "core/flow/coordinate_map.h"

#include "core/base/parallel.h"
#include "core/flow/field.h"

#include <cstring>

#include <glm/common.hpp>

namespace fumage {

namespace {

/// Four floats in one register, on every instruction set.
using Float4 = float __attribute__((vector_size(16)));

Float4 quadAt(const float* from)
{
    Float4 out;
    std::memcpy(&out, from, sizeof(out));
    return out;
}

glm::vec3 firstThree(Float4 quad)
{
    return {quad[0], quad[1], quad[2]};
}

} // namespace

void CoordinateMap::seed(const AirGrid& on)
{
    const AirField like(on);
    grid = on;
    row = like.row;
    plane = like.plane;
    quads.assign(like.quads.size(), 0.0F);
    parallelFor(static_cast<std::size_t>(on.cells.z + 1), [&](std::size_t k) {
        for (int j = 0; j <= on.cells.y; ++j) {
            float* to = quads.data() + k * plane + static_cast<std::size_t>(j) * row;
            for (int i = 0; i <= on.cells.x; ++i, to += 4) {
                const glm::vec3 place = on.corner + on.cell * glm::vec3(i, j, static_cast<int>(k));
                to[0] = place.x;
                to[1] = place.y;
                to[2] = place.z;
                to[3] = 0.0F;
            }
        }
    });
}

AdvectedPlace advectedPlace(const CoordinateMap& map, const glm::vec3& place)
{
    const AirGrid& grid = map.grid;
    const glm::vec3 end(grid.cells);
    const glm::vec3 cells = (place - grid.corner) / grid.cell;
    const glm::vec3 inside = glm::clamp(cells, glm::vec3(0.0F), end);
    const glm::vec3 low = glm::min(glm::floor(inside), end - 1.0F);
    const glm::vec3 t = inside - low;
    const glm::uvec3 node(low);
    const float* from = map.quads.data() + std::size_t{4} * node.x + map.row * node.y + map.plane * node.z;
    const auto mix = [](Float4 a, Float4 b, float share) { return a + (b - a) * share; };
    // The ends of the four rows along x, then of the two sides along y.
    const auto ends = [&](std::size_t offset) { return std::pair(quadAt(from + offset), quadAt(from + offset + 4)); };
    const auto [a0, a1] = ends(0);
    const auto [b0, b1] = ends(map.row);
    const auto [c0, c1] = ends(map.plane);
    const auto [e0, e1] = ends(map.plane + map.row);
    const Float4 alongX = mix(mix(a1 - a0, b1 - b0, t.y), mix(c1 - c0, e1 - e0, t.y), t.z);
    const Float4 a = mix(a0, a1, t.x);
    const Float4 b = mix(b0, b1, t.x);
    const Float4 c = mix(c0, c1, t.x);
    const Float4 e = mix(e0, e1, t.x);
    const Float4 front = mix(a, b, t.y);
    const Float4 back = mix(c, e, t.y);
    const float perMetre = 1.0F / grid.cell;
    AdvectedPlace out;
    out.place = firstThree(mix(front, back, t.z)) + (cells - inside) * grid.cell;
    out.slope[0] = firstThree(alongX) * perMetre;
    out.slope[1] = firstThree(mix(b - a, e - c, t.z)) * perMetre;
    out.slope[2] = firstThree(back - front) * perMetre;
    return out;
}

} // namespace fumage
