#pragma once

#include "core/lighting/light_kernel.h"

namespace fumage {

/// Lets the sun through a grid along one of its axes.
/// @param job       the sun; its intensity is that of the light
/// @param axis      0 u, 1 v, 2 w
/// @param fromAbove light comes from the upper end of the axis and travels towards lower indices
/// @param light     one float a cell, with room for a vector past the last
void addSunFrom(const LightGrid& grid, const SunJob& job, int axis, bool fromAbove, float* light);

} // namespace fumage
