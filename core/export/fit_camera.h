#pragma once

#include "core/export/sequence.h"
#include "core/scene/scene.h"

namespace fumage {

/// Finds the camera that shows all of the smoke of an animation and no more, from the direction in which it looks: no
/// pixel on the border of any of the frames reaches an alpha of 1/255. It moves, and does not turn or zoom; on a
/// turntable it stays on its circle.
///
/// Particles give a first guess; small pictures of the frames then show where smoke is to be seen, since what is faint
/// at the rim needs no room.
/// @param effect its quality is taken to be good
/// @param task   hears of ProgressPhase::Fitting after each frame that was looked at; each is looked at several times
/// @error Cancelled, OutOfMemory; OutOfRange where no frame has smoke
/// O(frames), each as a frame of a sequence at a small size, three times.
[[nodiscard]] Result<Camera> fitCamera(const Scene& scene, const FrameRange& frames, const Task& task = {});

} // namespace fumage
