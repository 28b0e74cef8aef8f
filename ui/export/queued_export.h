#pragma once

#include "ui/export/export_check.h"

namespace fumage::ui {

/// What has become of an export of the queue.
enum class ExportState {
    Held, ///< left by a program that is gone; waits for somebody to start it
    Starting, ///< waits, once it is known that no other that waits writes its files
    Waiting,
    Running,
    Done,
    Failed,
    Cancelled,
};

/// An export of the queue.
struct QueuedExport {
    quint64 id = 0; ///< never 0, and never that of another
    std::shared_ptr<const ExportJob> job;
    ExportState state = ExportState::Waiting;
    int done = 0; ///< files of `total` that are done while it runs
    int total = 0; ///< 0: not known yet
    QString told{}; ///< how far it is, or what came of it, in words
    QString remark{}; ///< of one that is done: what the artist should know of the result
    CheckMark check{}; ///< of one that is done: whether its files are as they were written

    /// Whether it will be done without anybody doing something for it.
    [[nodiscard]] bool isActive() const
    {
        return state == ExportState::Starting || state == ExportState::Waiting || state == ExportState::Running;
    }
    /// Whether it is still to be done.
    [[nodiscard]] bool isUnfinished() const { return isActive() || state == ExportState::Held; }
    /// Whether its files are being held against its manifest, or are to be.
    [[nodiscard]] bool isChecked() const { return check.state == CheckState::Running; }
    /// Whether they can be.
    [[nodiscard]] bool canBeChecked() const;
};

/// What is said of a state where there is nothing else to say.
[[nodiscard]] QString usualText(ExportState state);
/// What is written, its file, its folder.
[[nodiscard]] QString placeOf(const ExportPlan& plan);
/// How far it is, or what came of it, with one line to say it in.
[[nodiscard]] QString lineOf(const QueuedExport& one);
/// The same with all that there is to say.
[[nodiscard]] QString wholeTextOf(const QueuedExport& one, const QString& between);
/// Where it goes, and how it stands.
[[nodiscard]] QString tipOf(const QueuedExport& one);
/// How much is done, 0 to 1, of the export or of what looks at its files; less than 0: not known.
[[nodiscard]] double shareOf(const QueuedExport& one);

/// Whether one export may write over files of another, or over its manifest, by their names alone: the disk may be
/// slow.
[[nodiscard]] bool mayShareFiles(const ExportPlan& one, const ExportPlan& other);

} // namespace fumage::ui
