#include "core/flow/coordinate_step.h"

#include "core/base/parallel.h"
#include "core/flow/coordinate_kernel.h"

#include <utility>

namespace fumage {

namespace {

void carryPart(const AirField& field, float seconds, CoordinateMap& map, CoordinateMap& room)
{
    room.grid = map.grid;
    room.row = map.row;
    room.plane = map.plane;
    if (room.quads.size() != map.quads.size()) {
        room.quads.assign(map.quads.size(), 0.0F);
    }
    parallelFor(static_cast<std::size_t>(map.grid.cells.z) + 1,
        [&](std::size_t plane) { carryPlane(map, field, seconds, static_cast<int>(plane), room); });
    std::swap(map, room);
}

} // namespace

void stepCoordinates(CoordinateMap& map, const AirField& field, float dt, CoordinateMap& room)
{
    for (const AirField& part : field.earlier) {
        carryPart(part, dt * part.share, map, room);
    }
    carryPart(field, dt * field.share, map, room);
}

} // namespace fumage
