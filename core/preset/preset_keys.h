#pragma once

#include <string_view>

namespace fumage {

/// Members of the root, and names of what stands beside their groups.
inline constexpr std::string_view kScene = "scene";
inline constexpr std::string_view kLayers = "layers";
inline constexpr std::string_view kLayer = "layer";

} // namespace fumage
