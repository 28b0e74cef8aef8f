#include "ui/export/export_entry.h"

#include "ui/document/text.h"

#include <QWidget>

namespace fumage::ui {

ExportEntry::ExportEntry(ExportQueue& queue, AskForChoice askForChoice, QWidget* window)
    : m_queue(queue)
    , m_askForChoice(std::move(askForChoice))
    , m_window(window)
{
}

void ExportEntry::enter(ExportJob job, std::optional<OnClash> answered)
{
    m_job = std::move(job);
    m_answered = answered;
    m_isBusy = true;
    look();
}

void ExportEntry::look()
{
    m_others = m_queue.activeJobs();
    m_search.ask([this, plan = m_job.plan, others = m_others](const AnswerJob::Tell& tell,
                     const std::stop_token&) { tell([this, clash = findClash(plan, others)] { take(clash); }); },
        [this](const Error& why) {
            m_isBusy = false;
            emit refused(told(why));
            emit ended();
        });
}

void ExportEntry::take(const ExportClash& clash)
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
            emit refused(told(id.error()));
        }
    }
    emit ended();
}

} // namespace fumage::ui
