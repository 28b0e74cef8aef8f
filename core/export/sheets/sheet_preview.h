#pragma once

#include "core/export/export_task.h"
#include "core/export/plan.h"
#include "core/export/sheets/sheet_playback.h"
#include "core/scene/scene.h"

#include <memory>

namespace fumage {

/// A flipbook that plays before it is written.
struct SheetPreview {
    PassSheet sheet; ///< its colours as an engine has them: those of a PNG decoded again, those of an EXR as they are
    std::unique_ptr<const SheetPlayback> playback; ///< of the sheet
    Output output; ///< how its colours are displayed
    double cellsPerSecond = 0.0; ///< keeps the speed of the effect
    bool isWhole = true; ///< cells are as large as those that will be written; else smaller
};

/// Renders the cells of a plan for a flipbook, as they will be written; large ones smaller.
/// @param mostEdge  of a cell, pixels
/// @param mostPixels of all of them together
/// @error those of runExport()
/// O(cells).
[[nodiscard]] Result<std::shared_ptr<const SheetPreview>> previewFlipbook(
    const Scene& scene, const ExportPlan& plan, int mostEdge, std::int64_t mostPixels, const ExportTask& task = {});

} // namespace fumage
