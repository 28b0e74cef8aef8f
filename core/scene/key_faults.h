#pragma once

#include "core/scene/scene.h"

#include <vector>

namespace fumage {

/// What key frames do that nobody may want.
enum class KeyFault {
    OpenLoop, ///< in a loop, the value at its end is another than at its beginning: it jumps there
    AfterEnd, ///< there are key frames after the end of the timeline
    RateJumps, ///< a rate that is summed up, as that of gusts, changes at once. Emission may: that is a burst
};

/// What a track does that nobody may want, in a timeline.
[[nodiscard]] std::vector<KeyFault> keyFaults(const Track& track, const Timeline& timeline);

/// The track without one of its faults. An open loop gets key frames with one value at its beginning and its end, in
/// place of those after it; key frames after the end are moved into the timeline, all in the same proportion, to whole
/// frames; a rate that jumps goes smoothly from key to key.
[[nodiscard]] Track withoutFault(const Track& track, KeyFault fault, const Timeline& timeline);

/// Whether a visible layer, or what all layers share, has such faults.
[[nodiscard]] bool hasKeyFaults(const Scene& scene);

/// The scene without all such faults of its visible layers and of what all layers share. Locked layers stay.
[[nodiscard]] Scene withoutKeyFaults(const Scene& scene);

} // namespace fumage
