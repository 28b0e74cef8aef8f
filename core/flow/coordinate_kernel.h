#pragma once

#include "core/flow/coordinate_map.h"
#include "core/flow/field.h"

namespace fumage {

/// One plane of nodes of a map that air carries on for some time.
/// @param from,to of the field's grid, not the same
void carryPlane(const CoordinateMap& from, const AirField& field, float seconds, int plane, CoordinateMap& to);

} // namespace fumage
