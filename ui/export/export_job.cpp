#include "ui/export/export_job.h"

#include "ui/document/text.h"

namespace fumage::ui {

ExportJob::ExportJob(QObject* parent)
    : QObject(parent)
{
}

void ExportJob::start(const Effect& effect, const ExportPlan& plan)
{
    if (m_running) {
        return;
    }
    m_running = true;
    m_lastPlan = plan;
    m_timer.start();
    emit started();
    m_thread = std::jthread([this, effect, plan](const std::stop_token& stop) {
        const auto report = [this](int done, int total) {
            QMetaObject::invokeMethod(
                this, [this, done, total] {
                    constexpr double kMillisecondsASecond = 1000.0;
                    const double elapsed = static_cast<double>(m_timer.elapsed()) / kMillisecondsASecond;
                    emit progressed(done, total, done > 0 ? elapsed / done * (total - done) : -1.0);
                },
                Qt::QueuedConnection);
        };
        const Status status = runExport(effect, plan, report, stop);
        QMetaObject::invokeMethod(
            this, [this, status] { end(status); }, Qt::QueuedConnection);
    });
}

void ExportJob::cancel()
{
    m_thread.request_stop();
}

void ExportJob::end(const Status& status)
{
    m_running = false;
    if (status) {
        emit finished(firstFileOf(*m_lastPlan));
    } else if (status.error().code == ErrorCode::Cancelled) {
        emit cancelled();
    } else {
        emit failed(toQString(status.error().text()));
    }
}

} // namespace fumage::ui
