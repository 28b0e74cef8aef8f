#include "core/effect/track_jumps.h"

namespace fumage {

bool jumpsOnWay(const Track& track, double from, double to, double end)
{
    return to >= from ? track.jumpsIn(from, to)
                      : track.at(end) != track.at(0.0) || track.jumpsIn(from, end) || track.jumpsIn(0.0, to);
}

} // namespace fumage
