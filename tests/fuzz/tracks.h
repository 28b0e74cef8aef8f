#pragma once

#include "tests/fuzz/expect.h"

#include "core/effect/track.h"
#include "core/effect/track_edits.h"
#include "core/effect/value.h"
#include "core/scene/key_faults.h"
#include "core/scene/key_table.h"

#include <array>

namespace fumage::tests {

/// What holds of any track that was taken: whenever it is asked its value lies in the hard range, and what is written
/// of it, mended or added to it is a track again.
/// @param track that checkTrack() finds nothing wrong with
inline void expectTrack(const Track& track, const Timeline& timeline)
{
    const Parameter& parameter = *track.parameter;
    FUMAGE_EXPECT(checkTrack(track));
    const double first = track.keys.front().seconds;
    const double last = track.keys.back().seconds;
    const std::array times{-1e6, -1.0, 0.0, first, 0.5 * (first + last), last, last + 1e-3, 7.0, 1e6};
    for (const double seconds : times) {
        FUMAGE_EXPECT(!clampValue(parameter, track.at(seconds)).changed);
        static_cast<void>(track.jumpsIn(seconds, seconds + 1.0));
    }
    FUMAGE_EXPECT(track.at(first) == track.keys.front().value);
    for (const KeyFault fault : keyFaults(track, timeline)) {
        FUMAGE_EXPECT(checkTrack(withoutFault(track, fault, timeline)));
    }
    const Result<Track> read = parseKeyTable(parameter, formatKeyTable(track), timeline.frameRate);
    FUMAGE_EXPECT(read && read.value().keys.size() == track.keys.size());
    for (std::size_t i = 0; i < track.keys.size(); ++i) {
        FUMAGE_EXPECT(read.value().keys[i].seconds == track.keys[i].seconds);
        FUMAGE_EXPECT(read.value().keys[i].value == track.keys[i].value);
    }
    Track more = track;
    if (track.keys.size() < kMaxKeyFrames) {
        insertKey(more, 0.5 * (first + last) + 0.01);
        FUMAGE_EXPECT(checkTrack(more));
    }
}

} // namespace fumage::tests
