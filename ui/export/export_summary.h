#pragma once

#include "ui/document/document.h"

#include "core/export/plan.h"

namespace fumage::ui {

/// Whether a plan can be carried out as far as its numbers tell.
[[nodiscard]] bool isPossible(const ExportPlan& plan);

/// What a plan writes, or what stands in its way.
[[nodiscard]] QString summaryOf(const ExportPlan& plan, const Effect& effect);

/// A file for a plan that has none yet: beside the document, and named after it.
[[nodiscard]] QString suggestedPath(const ExportPlan& plan, const Document& document);

/// The format that the ending of a path asks for, as an ImageFormat or ParticleFormat; nothing where it asks for none of this kind.
[[nodiscard]] std::optional<int> formatNamedBy(const QString& path, ExportKind kind);

/// The same path for another format: its ending goes, where it is one that exports have, and the plan's comes.
[[nodiscard]] QString withEndingOf(const ExportPlan& plan, const QString& path);

} // namespace fumage::ui
