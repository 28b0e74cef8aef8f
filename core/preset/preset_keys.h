#pragma once

#include <array>
#include <string_view>

namespace fumage {

/// Members of the root, and names of what stands beside their groups.
inline constexpr std::string_view kScene = "scene";
inline constexpr std::string_view kLayers = "layers";
inline constexpr std::string_view kLayer = "layer";

/// Members of a layer beside its groups.
inline constexpr std::string_view kLayerName = "name";
inline constexpr std::string_view kLayerVisible = "visible";
inline constexpr std::string_view kLayerLocked = "locked";
inline constexpr std::string_view kLayerTag = "tag";
inline constexpr std::string_view kLayerFrom = "from";

/// What changes over time, of the scene or of a layer, and members of each track.
inline constexpr std::string_view kAnimation = "animation";
inline constexpr std::string_view kTrackParameter = "key";
inline constexpr std::string_view kTrackBefore = "before";
inline constexpr std::string_view kTrackAfter = "after";
inline constexpr std::string_view kTrackKeys = "keys";

/// Moments with names of the scene, and members of each.
inline constexpr std::string_view kMarkers = "markers";
inline constexpr std::string_view kMarkerName = "name";
inline constexpr std::string_view kMarkerTime = "time";

/// What a ColourTag is called in files.
inline constexpr std::array<std::string_view, 8> kColourTags{
    "none", "red", "orange", "yellow", "green", "blue", "violet", "grey"};

} // namespace fumage
