#pragma once

#include "ui/export/file_conflict.h"
#include "ui/export/export_queue.h"
#include "ui/concurrency/async_request.h"

#include <QPointer>

namespace fumage::ui {

/// Adds exports to the queue, once a person has said what becomes of files that are there. It looks for them on a
/// thread of its own: there may be many, and the disk far away.
class ExportSubmission : public QObject {
    Q_OBJECT

public:
    /// @param window parent of what is asked
    ExportSubmission(ExportQueue& queue, AskForChoice askForChoice, QWidget* window);

    /// One at a time: what is asked for last counts.
    /// @param answered what was answered before, and is not asked again
    void enter(ExportJob job, std::optional<ConflictPolicy> answered = {});
    /// Whether one is being looked at.
    [[nodiscard]] bool isBusy() const { return m_isBusy; }

signals:
    /// It is in the queue.
    /// @param plan as it was added @param answered what became of files that are there; nothing: there are none
    void entered(quint64 id, const fumage::ExportPlan& plan, std::optional<fumage::ui::ConflictPolicy> answered);
    /// The queue does not take it.
    void refused(const QString& message);
    /// No more is looked at, whatever came of it.
    void ended();

private:
    void look();
    void take(const FileConflict& clash);

    ExportQueue& m_queue;
    const AskForChoice m_askForChoice;
    const QPointer<QWidget> m_window;
    ExportJob m_job;
    std::optional<ConflictPolicy> m_answered;
    ExportJobs m_others; ///< when it was looked at
    bool m_isBusy = false;
    AsyncRequest m_search; ///< last: its thread ends first
};

} // namespace fumage::ui
