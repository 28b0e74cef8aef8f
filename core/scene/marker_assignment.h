#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

#include <string_view>

namespace fumage {

/// Sets the markers of a name, as --marker does: "Boom=0.5" or "Hit=0.5; 1.25" puts one at each of these times, s, in
/// place of those that have the name; "Boom=" alone takes them out. What follows the last equals sign are the times.
/// @return false: no time is clamped
/// @error Syntax; that of checkMarkers(). The scene is then as it was
[[nodiscard]] Result<bool> markScene(Scene& scene, std::string_view text);

} // namespace fumage
