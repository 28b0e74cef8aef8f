#pragma once

#include "ui/document/document.h"

#include "core/export/plan.h"

namespace fumage::ui {

/// Whether a plan can be carried out as far as its numbers tell.
[[nodiscard]] bool isPossible(const ExportPlan& plan, const Effect& effect);

/// What a plan writes, or what stands in its way.
[[nodiscard]] QString summaryOf(const ExportPlan& plan, const Effect& effect);

/// Whether two plans for flipbooks fill the same cells.
[[nodiscard]] bool haveSameCells(const ExportPlan& a, const ExportPlan& b);

/// A file for a plan that has none yet: beside the document, and named after it.
[[nodiscard]] QString suggestedPath(const ExportPlan& plan, const Document& document);

} // namespace fumage::ui
