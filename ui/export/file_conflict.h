#pragma once

#include "ui/export/queue_file.h"
#include "ui/widgets/choice_question.h"

#include <optional>

namespace fumage::ui {

/// The files that jobs write. They leave one another alone: that was seen to when they were added.
[[nodiscard]] JobFiles filesOf(const ExportJobs& jobs);

/// The plan of a job under the first name of which no file is there yet, and that none of some others writes:
/// "smoke-2_####.png" after "smoke_####.png".
[[nodiscard]] ExportPlan numberedOn(ExportJob job, const JobFiles& others = {});

/// What stands in the way of an export.
struct FileConflict {
    Status apart = Done{}; ///< an error where an export that waits writes one of its files
    int there = 0; ///< how many of its files are on the disk already
    QString first; ///< of these
    ExportPlan free; ///< the same under a name that nothing stands in the way of

    [[nodiscard]] bool isNone() const { return apart && there == 0; }
};

/// Looks at the disk for each file of an export: not for the thread of the window.
/// @param others that wait or run
[[nodiscard]] FileConflict findClash(const ExportJob& job, const ExportJobs& others);

/// What becomes of an export of which files are there already.
enum class ConflictPolicy {
    Overwrite,
    KeepBoth, ///< see numberedOn()
    Cancel,
};

/// Asks a person what is to become of files that are there, or that an export of the queue is to write.
/// @param answered what was answered before, and is not asked again; takes the answer
/// @return the plan as it may be added to the queue; nothing: it is not to be
[[nodiscard]] std::optional<ExportPlan> settled(QWidget* parent, const AskForChoice& ask, const FileConflict& clash,
    const ExportPlan& plan, std::optional<ConflictPolicy>& answered);

} // namespace fumage::ui
