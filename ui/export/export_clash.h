#pragma once

#include "ui/export/export_queue.h"
#include "ui/face/choice_question.h"

#include "core/export/jobs.h"

#include <optional>

namespace fumage::ui {

/// The files of a plan that are there already.
[[nodiscard]] QStringList filesThere(const ExportPlan& plan);

/// The same job under the first name of which no file is there yet, and that none of some others writes: "smoke-2_####.png" after "smoke_####.png".
[[nodiscard]] ExportPlan numberedOn(ExportPlan plan, const JobFiles& others = {});

/// What becomes of an export of which files are there already.
enum class OnClash {
    Overwrite,
    NumberOn, ///< see numberedOn()
    Cancel,
};

/// Asks a person what is to become of files that are there, or that an export of the queue is to write.
/// @param answered what was answered before, and is not asked again; takes the answer
/// @return the plan as it may be added to the queue; nothing: it is not to be
[[nodiscard]] std::optional<ExportPlan> settled(QWidget* parent, const AskForChoice& ask, const ExportQueue& queue, const ExportPlan& plan, std::optional<OnClash>& answered);

} // namespace fumage::ui
