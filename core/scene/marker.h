#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// Most markers of a scene, and most bytes of a marker's name.
inline constexpr std::size_t kMaxMarkers = 256;
inline constexpr std::size_t kMaxMarkerName = 100;

/// Latest time of a marker, s: that of key frames.
inline constexpr double kMaxMarkerSeconds = 100'000.0;

/// A moment of the timeline with a name, of which a game is told as the effect passes it. It changes no picture.
struct Marker {
    std::string name; ///< UTF-8, without controls; several may share one
    double seconds = 0.0; ///< since frame 0, so that another frame rate moves none
    friend bool operator==(const Marker&, const Marker&) = default;
};

/// What keeps a marker from being one.
/// @error NotFinite, OutOfRange: its time is no number from 0 to kMaxMarkerSeconds; NotUtf8, WrongType: its name is
/// empty or has controls; TooLarge: it is longer than kMaxMarkerName. They have no place.
[[nodiscard]] Status checkMarker(const Marker& marker);

/// What keeps markers from being those of a scene.
/// @error that of checkMarker(); TooLarge: more than kMaxMarkers; OutOfRange: they are not in the order of their times
[[nodiscard]] Status checkMarkers(std::span<const Marker> markers);

/// Adds a marker after those of its time and of earlier ones.
/// @param markers in the order of their times
/// @return where it is now
std::size_t addMarker(std::vector<Marker>& markers, Marker marker);

/// A text as a name that checkMarker() takes: on one line, without controls and spaces at its ends, cut at a
/// character's border to kMaxMarkerName. It may be empty.
[[nodiscard]] std::string markerNameOf(std::string_view text);

} // namespace fumage
