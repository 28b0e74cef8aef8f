#pragma once

#include "ui/face/choice_question.h"

#include "core/export/plan.h"

namespace fumage::ui {

/// The files of a plan that are there already.
[[nodiscard]] QStringList filesThere(const ExportPlan& plan);

/// The same plan under the first name of which no file is there yet: "smoke-2_####.png" after "smoke_####.png".
[[nodiscard]] ExportPlan numberedOn(ExportPlan plan);

/// What becomes of an export of which files are there already.
enum class OnClash {
    Overwrite,
    NumberOn, ///< see numberedOn()
    Cancel,
};

/// @param there not empty
[[nodiscard]] OnClash askOnClash(QWidget* parent, const AskForChoice& ask, const QStringList& there);

} // namespace fumage::ui
