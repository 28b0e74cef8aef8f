#pragma once

#include "ui/document/document.h"

#include "core/export/plan.h"

#include <optional>

namespace fumage::ui {

/// Whether a plan can be carried out as far as its numbers tell.
[[nodiscard]] bool isPossible(const ExportPlan& plan, const Scene& scene);

/// What a plan writes, or what stands in its way.
[[nodiscard]] QString summaryOf(const ExportPlan& plan, const Scene& scene);

/// A way out for a plan that does not do what is wanted of it: other frames, or another grid.
struct ExportOffer {
    QString text; ///< of a button
    FrameRange frames;
    int columns = 0;
    int rows = 0;
};
/// What may be offered for a plan: the largest grid that its frames fill, or the frames that close its loop; none:
/// nothing.
[[nodiscard]] std::optional<ExportOffer> offerFor(const ExportPlan& plan, const Scene& scene);

/// Whether two plans for flipbooks fill the same cells.
[[nodiscard]] bool haveSameCells(const ExportPlan& a, const ExportPlan& b);

/// A file for a plan that has none yet: beside the document, and named after it.
[[nodiscard]] QString suggestedPath(const ExportPlan& plan, const Document& document);

} // namespace fumage::ui
