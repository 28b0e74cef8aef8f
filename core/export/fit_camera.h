#pragma once

#include "core/export/export_task.h"
#include "core/export/sequence.h"
#include "core/scene/scene.h"

#include <span>

namespace fumage {

/// Most of the smoke that fitCamera() leaves outside, percent.
inline constexpr float kMaxOutlierPercent = 5.0F;

/// Finds the camera that shows all of the smoke of some frames and no more, from the direction in which it looks: no
/// pixel on the border of any of the frames reaches an alpha of 1/255. It moves, and does not turn or zoom; on a
/// turntable it stays on its circle.
///
/// Particles give a first guess; small pictures of the frames then show where smoke is to be seen, since what is faint
/// at the rim needs no room.
///
/// With outliers it shows the smoke without a share of it that needs the most room, as stray sparks do, and comes
/// nearer: of what the pictures that show all smoke have, alphas summed over all pixels of all frames, at most that
/// share is left outside, see cutOutliers(). What is left outside may be cut off at the border. Sparks that fly towards
/// the camera do not hold it off where they are no more than that share of the smoke; they may pass it.
/// @param scene    its quality is taken to be good
/// @param frames   their numbers, one or more, in rising order
/// @param outliers percent of the smoke that may be outside, taken to be within 0 to kMaxOutlierPercent; 0: none, and
///                 the camera is as without them to the bit
/// @param task     hears of ProgressPhase::Fitting after each frame that was looked at; each is looked at several times
/// @error Cancelled, OutOfMemory; OutOfRange where no frame has smoke
/// O(frames), each as a frame of a sequence at a small size, three times; six times with outliers, and then 2 KB of
/// memory a frame. What lies between the frames is simulated, and not looked at.
[[nodiscard]] Result<Camera> fitCamera(
    const Scene& scene, std::span<const int> frames, float outliers, const ExportTask& task = {});

/// The same of all frames of a range.
[[nodiscard]] inline Result<Camera> fitCamera(
    const Scene& scene, const FrameRange& frames, float outliers, const ExportTask& task = {})
{
    return fitCamera(scene, numbersOf(frames), outliers, task);
}

/// The same without outliers.
[[nodiscard]] inline Result<Camera> fitCamera(const Scene& scene, const FrameRange& frames, const ExportTask& task = {})
{
    return fitCamera(scene, frames, 0.0F, task);
}

} // namespace fumage
