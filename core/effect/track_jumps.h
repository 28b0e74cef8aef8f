#pragma once

#include "core/effect/track.h"

namespace fumage {

/// Whether a value jumps on the way from one time to another.
/// @param from,to s since frame 0, 0 or more; where to comes before from, the way goes through the end of a loop
/// @param end of that loop, s
[[nodiscard]] bool jumpsOnWay(const Track& track, double from, double to, double end);

} // namespace fumage
