#include "ui/export/export_job.h"

#include "ui/document/text.h"

#include <system_error>

#include <QLocale>
#include <QStringList>

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
    m_hasBegun = false;
    emit started();
    const auto work = [this, effect, plan](const std::stop_token& stop) {
        const auto report = [this](Work part, int done, int total) {
            QMetaObject::invokeMethod(
                this, [this, part, done, total] { tell(part, done, total); }, Qt::QueuedConnection);
        };
        const Result<std::optional<Flipbook>> result = runExport(effect, plan, report, stop);
        QMetaObject::invokeMethod(
            this, [this, result] { end(result); }, Qt::QueuedConnection);
    };
    try {
        m_thread = std::jthread(work);
    } catch (const std::system_error&) {
        end(Error{ErrorCode::OutOfMemory, said("the export cannot be started: there are not enough memory or threads"), {}, said("Close other programs")});
    }
}

void ExportJob::tell(Work work, int done, int total)
{
    if (work == Work::Frames) {
        m_hasBegun = true;
        constexpr double kMillisecondsASecond = 1000.0;
        const double elapsed = static_cast<double>(m_timer.elapsed()) / kMillisecondsASecond;
        emit progressed(done, total, done > 0 ? elapsed / done * (total - done) : -1.0);
    } else if (!m_hasBegun) {
        m_timer.restart();
        const int percent = static_cast<int>(100.0 * done / total);
        switch (work) {
        case Work::Air: emit preparing(tr("Baking the air: %1 %").arg(percent)); break;
        case Work::Fitting: emit preparing(tr("Looking where the smoke is: %1 %").arg(percent)); break;
        default: emit preparing(tr("Simulating what comes before: %1 %").arg(percent)); break;
        }
    }
}

void ExportJob::cancel()
{
    m_thread.request_stop();
}

void ExportJob::end(const Result<std::optional<Flipbook>>& result)
{
    m_running = false;
    if (result) {
        const QString remark = result.value() && result.value()->cutOff ? complaint(*result.value()->cutOff) : QString();
        emit finished(toQString(firstFile(*m_lastPlan).string()), remark);
    } else if (result.error().code == ErrorCode::Cancelled) {
        emit cancelled();
    } else {
        emit failed(told(result.error()));
    }
}

QString ExportJob::complaint(const CutOff& cut)
{
    QStringList edges;
    for (const auto& [reached, name] : {std::pair{cut.left, tr("left")}, std::pair{cut.right, tr("right")}, std::pair{cut.top, tr("top")}, std::pair{cut.bottom, tr("bottom")}}) {
        if (reached) {
            edges << name;
        }
    }
    const QString what = cut.distance > 0.0F ? tr("The smoke is cut off at the edge of cells (%1) in frames %2 to %3: let the camera be fitted, or move it back to %4 m.")
                                             : tr("The smoke is cut off at the edge of cells (%1) in frames %2 to %3: let the camera be fitted.");
    const QString told = what.arg(edges.join(QStringLiteral(", "))).arg(cut.firstFrame).arg(cut.lastFrame);
    return cut.distance > 0.0F ? told.arg(QLocale().toString(cut.distance, 'g', 3)) : told;
}

} // namespace fumage::ui
