#pragma once

#include "core/flow/coordinate_map.h"
#include "core/flow/field.h"

namespace fumage {

/// Carries coordinates on with the air of a step: X'(x) = X(x - dt u), by way of the middle of the step.
/// @param field on the grid of the map; its earlier parts carry first
/// @param dt of the whole step, s
/// @param room to work in; kept, so that its memory is allocated once
/// O(nodes), on all threads. The same bits for any number of them and on every instruction set.
void stepCoordinates(CoordinateMap& map, const AirField& field, float dt, CoordinateMap& room);

} // namespace fumage
