#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

#include <string_view>

namespace fumage {

/// Lets a parameter change over time, as --animate does: "camera.yaw=0:0; 2:90:linear" or "flames/emitter.rate=1:0;
/// 2:1; after=loop". A key frame is its time in seconds, its value as --set takes it, and its ease: auto (the default),
/// linear or hold. "key=" alone takes all key frames out.
/// @return whether a value had to be clamped
/// @error that of layerAssignment(), of parseValue() and of checkTrack(); Syntax
[[nodiscard]] Result<bool> animateScene(Scene& scene, std::string_view text);

} // namespace fumage
