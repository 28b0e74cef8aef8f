#include "ui/export/export_submission.h"

#include "ui/document/text.h"

#include <QWidget>

namespace fumage::ui {

ExportSubmission::ExportSubmission(ExportQueue& queue, AskForChoice askForChoice, QWidget* window)
    : m_queue(queue)
    , m_askForChoice(std::move(askForChoice))
    , m_window(window)
{
}

void ExportSubmission::enter(ExportJob job, std::optional<ConflictPolicy> answered)
{
    m_job = std::move(job);
    m_answered = answered;
    m_isBusy = true;
    look();
}

void ExportSubmission::look()
{
    m_others = m_queue.activeJobs();
    m_search.ask([this, job = m_job, others = m_others](const AsyncRequest::Report& report,
                     const std::stop_token&) { report([this, clash = findClash(job, others)] { take(clash); }); },
        [this](const Error& why) {
            m_isBusy = false;
            emit refused(translated(why));
            emit ended();
        });
}

void ExportSubmission::take(const FileConflict& clash)
{
    if (m_others != m_queue.activeJobs()) {
        look(); // somebody else has added one meanwhile, or one is done
        return;
    }
    const std::optional<ExportPlan> wanted = settled(m_window, m_askForChoice, clash, m_job.plan, m_answered);
    m_isBusy = false;
    if (wanted) {
        ExportJob job = std::move(m_job);
        job.plan = *wanted;
        const Result<quint64> id = m_queue.add(std::move(job));
        if (id) {
            emit entered(id.value(), *wanted, m_answered);
        } else {
            emit refused(translated(id.error()));
        }
    }
    emit ended();
}

} // namespace fumage::ui
