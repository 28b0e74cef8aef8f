#pragma once

#include "core/export/export_task.h"
#include "core/export/plan.h"
#include "core/scene/scene.h"

#include <vector>

namespace fumage {

/// A grid and the largest cells that a budget leaves it.
struct SheetCandidate {
    int columns = 1;
    int rows = 1;
    int width = 1; ///< of a cell, pixels
    int height = 1;
    std::int64_t bytes = 0; ///< of all pictures of all sheets, as BC7, without mipmaps
    double decibels = 0.0; ///< see rateSheets()
};

/// The sheets among which a budget leaves the choice: few large cells, or many small ones. Cells have whole blocks of
/// BC7, are as large as the effect's output at most, and have its shape; sides are powers of two where the plan asks
/// for them. Grids that the frames do not fill are left out.
/// @param budget bytes
/// @param layers that are written: where each has a sheet, all of them fit into the budget
[[nodiscard]] std::vector<SheetCandidate> sheetsWithin(
    std::int64_t budget, const Output& largest, const ExportPlan& plan, std::size_t layers = 1);

/// Measures how well the candidates play: 16 moments of each as an engine shows them, blended along the vectors where
/// the plan has them, else cross-faded, and enlarged (bilinear) to the effect's output, against the frames there.
/// Colours are linear, premultiplied and at most 1, so decibels are those of scoreSheet().
/// @param plan for a flipbook; its columns and rows mean nothing here
/// @return sheetsWithin(), with decibels
/// @error OutOfRange where the budget is too small for any; those of sceneSeenBy() and flipbookSeenBy(), Cancelled
/// O(cells of all candidates).
[[nodiscard]] Result<std::vector<SheetCandidate>> rateSheets(
    const Scene& scene, const ExportPlan& plan, std::int64_t budget, const ExportTask& task = {});

/// The best of them; of equals the one that needs less memory.
/// @param candidates not empty
[[nodiscard]] const SheetCandidate& bestOf(const std::vector<SheetCandidate>& candidates);

} // namespace fumage
