#include "ui/work/answer_job.h"

namespace fumage::ui {

AnswerJob::AnswerJob(QObject* parent)
    : QObject(parent)
    , m_job([this](const Request& request, const std::stop_token& stop) { answer(request, stop); })
{
}

void AnswerJob::ask(Work work)
{
    m_job.post({++m_number, std::move(work)});
}

void AnswerJob::forget()
{
    m_job.post({++m_number, {}});
}

void AnswerJob::answer(const Request& request, const std::stop_token& stop)
{
    if (!request.work) {
        return;
    }
    const auto tell = [this, number = request.number](std::function<void()> news) {
        const auto unlessOld = [this, number, news = std::move(news)] {
            if (number == m_number) {
                news();
            }
        };
        QMetaObject::invokeMethod(this, unlessOld, Qt::QueuedConnection);
    };
    request.work(tell, stop);
}

} // namespace fumage::ui
