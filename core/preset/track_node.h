#pragma once

#include "core/effect/tracks.h"
#include "core/preset/node_talk.h"

#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// The tracks of a scene or of a layer.
struct TracksReading {
    Tracks tracks;
    std::vector<std::string> unknown; ///< the JSON of those whose parameter is not known here
};

/// Reads an "animation": a list of tracks, as {"key": "emitter.rate", "after": "loop", "keys": [[0, 0.2], [1.5, 1,
/// "hold"]]}. A key frame is its time in seconds, its value, and how it goes on from there: "auto", "linear", "hold" or
/// "free", the last followed by its slopes before and after it.
/// @param scope whose parameters they are of
/// @param text  that the node is of
/// @error what talk.error() makes of what is wrong, also of what checkTrack() and valueOf() say
[[nodiscard]] Result<TracksReading> readTracks(
    const JsonNode& node, Scope scope, std::string_view text, const NodeTalk& talk);

/// A track of them, on one line.
[[nodiscard]] std::string formatTrack(const Track& track);

} // namespace fumage
