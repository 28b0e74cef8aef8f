#pragma once

#include "core/simulation/frame.h"

#include <string>

namespace fumage {

/// The living particles of a frame as text, one a line after a heading:
/// id, x, y, z (m), vx, vy, vz (m/s, without turbulence), age (s), life (0..1), alpha (0..1), radius (m). Shortest round-trip numbers.
/// @param effect the look that alpha and radius follow
[[nodiscard]] std::string dumpCsv(const Frame& frame, const Effect& effect);

/// The same as a binary little-endian PLY of vertices, with the same properties.
[[nodiscard]] std::string dumpPly(const Frame& frame, const Effect& effect);

} // namespace fumage
