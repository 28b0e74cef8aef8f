#include "ui/work/answer_job.h"

namespace fumage::ui {

AnswerJob::AnswerJob(QObject* parent)
    : QObject(parent)
    , m_job([this](const Request& request, const std::stop_token& stop) { answer(request, stop); },
          [this](const Request& request, const Error& why) {
              tellerOf(request)([failed = request.failed, why] { failed(why); });
          })
{
}

void AnswerJob::ask(Work work, Failed failed)
{
    m_job.post({++m_number, std::move(work), std::move(failed)});
}

void AnswerJob::forget()
{
    m_job.post({++m_number, {}, {}});
}

AnswerJob::Tell AnswerJob::tellerOf(const Request& request)
{
    return [this, number = request.number](std::function<void()> news) {
        const auto unlessOld = [this, number, news = std::move(news)] {
            if (number == m_number) {
                news();
            }
        };
        QMetaObject::invokeMethod(this, unlessOld, Qt::QueuedConnection);
    };
}

void AnswerJob::answer(const Request& request, const std::stop_token& stop)
{
    if (request.work) {
        request.work(tellerOf(request), stop);
    }
}

} // namespace fumage::ui
