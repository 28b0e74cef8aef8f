#include "core/scene/marker_assignment.h"

#include "core/base/text.h"

#include <optional>
#include <utility>

namespace fumage {

Result<bool> markScene(Scene& scene, std::string_view text)
{
    const std::size_t equals = text.rfind('=');
    const std::string name(trimmed(text.substr(0, equals)));
    const auto malformed = [&] {
        return Error{ErrorCode::Syntax, makeMessage("invalid marker %1", inQuotes(text)), {},
            makeMessage("Write NAME=SECONDS, with ; between several times, or NAME= to take them out")};
    };
    if (equals == std::string_view::npos || name.empty()) {
        return malformed();
    }
    std::vector<Marker> markers = scene.markers;
    std::erase_if(markers, [&](const Marker& marker) { return marker.name == name; });
    const std::string_view times = trimmed(text.substr(equals + 1));
    // Of more markers than there may be checkMarkers() tells.
    Parts parts(times, ';');
    for (auto part = parts.next(); !times.empty() && part && markers.size() <= kMaxMarkers; part = parts.next()) {
        const std::optional<double> seconds = parseDouble(trimmed(*part));
        if (!seconds) {
            return malformed();
        }
        const Marker marker{name, *seconds};
        if (const Status status = checkMarker(marker); !status) {
            return status.error();
        }
        addMarker(markers, marker);
    }
    if (const Status status = checkMarkers(markers); !status) {
        return status.error();
    }
    scene.markers = std::move(markers);
    return false;
}

} // namespace fumage
