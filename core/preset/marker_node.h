#pragma once

#include "core/preset/node_talk.h"
#include "core/scene/marker.h"

#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// The markers of a scene.
struct MarkersReading {
    std::vector<Marker> markers; ///< in the order of their times
    std::vector<std::string> unknown; ///< the JSON of those that have members which are not known here
};

/// Reads "markers": a list of objects, as {"name": "Boom", "time": 0.5}, the time in seconds. They may stand in any
/// order; of two at one time the first stays the first.
/// @param text that the node is of
/// @error what talk.error() makes of what is wrong, also of what checkMarkers() says
[[nodiscard]] Result<MarkersReading> readMarkers(const JsonNode& node, std::string_view text, const NodeTalk& talk);

/// A marker of them, on one line.
[[nodiscard]] std::string formatMarker(const Marker& marker);

} // namespace fumage
