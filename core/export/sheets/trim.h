#pragma once

#include "core/export/export_task.h"
#include "core/export/sequence.h"
#include "core/scene/scene.h"

namespace fumage {

/// Leaves out the first and the last frames in which no smoke is to be seen: no pixel of them reaches an alpha of
/// 1/255, or, where flames are clear, as much light.
/// @param effect as it is rendered: its output is the cell
/// @param task   hears of ProgressPhase::Fitting after each frame that was looked at
/// @error OutOfRange where no frame has smoke, and in a loop, which would no longer close; Cancelled and those of
/// Simulator and PassRenderer O(frames that are left out).
[[nodiscard]] Result<FrameRange> trimmed(const Scene& scene, const FrameRange& frames, const ExportTask& task = {});

} // namespace fumage
