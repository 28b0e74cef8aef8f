#include "ui/export/start_check.h"

#include "ui/export/file_conflict.h"

#include <algorithm>

namespace fumage::ui {

StartCheck::StartCheck(std::function<ExportJobs()> others, QObject* parent)
    : QObject(parent)
    , m_others(std::move(others))
{
}

void StartCheck::start(quint64 id, std::shared_ptr<const ExportJob> job)
{
    m_wanted.push_back({id, std::move(job)});
    if (m_wanted.size() == 1) {
        goOn();
    }
}

void StartCheck::giveUp(quint64 id)
{
    const auto found = std::ranges::find(m_wanted, id, &Wanted::id);
    if (found == m_wanted.end()) {
        return;
    }
    const bool isLookedAt = found == m_wanted.begin();
    m_wanted.erase(found);
    if (isLookedAt) {
        goOn();
    }
}

void StartCheck::goOn()
{
    if (m_wanted.empty()) {
        m_job.forget();
        return;
    }
    m_job.ask(
        [this, job = m_wanted.front().job, others = m_others()](
            const AsyncRequest::Report& report, const std::stop_token&) {
            report([this, others, apart = filesOf(others).check(*job)] { end(others, apart); });
        },
        [this](const Error& why) { end(m_others(), why); });
}

void StartCheck::end(const ExportJobs& asked, const Status& apart)
{
    const ExportJobs now = m_others();
    if (apart
        && std::ranges::any_of(now, [&](const auto& job) { return std::ranges::find(asked, job) == asked.end(); })) {
        goOn(); // one was added meanwhile
        return;
    }
    const quint64 id = m_wanted.front().id;
    m_wanted.pop_front();
    emit answered(id, apart); // before the next is asked for: it is one of the others then
    goOn();
}

} // namespace fumage::ui
