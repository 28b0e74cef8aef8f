#include "ui/concurrency/async_request.h"

namespace fumage::ui {

AsyncRequest::AsyncRequest(QObject* parent)
    : QObject(parent)
    , m_job([this](const Request& request, const std::stop_token& stop) { answer(request, stop); },
          [this](const Request& request, const Error& why) {
              tellerOf(request)([failed = request.failed, why] { failed(why); });
          })
{
}

void AsyncRequest::ask(Work work, Failed failed)
{
    m_job.post({++m_number, std::move(work), std::move(failed)});
}

void AsyncRequest::forget()
{
    m_job.post({++m_number, {}, {}});
}

AsyncRequest::Report AsyncRequest::tellerOf(const Request& request)
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

void AsyncRequest::answer(const Request& request, const std::stop_token& stop)
{
    if (request.work) {
        request.work(tellerOf(request), stop);
    }
}

} // namespace fumage::ui
