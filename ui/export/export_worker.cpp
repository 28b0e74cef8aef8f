#include "ui/export/export_worker.h"

#include "ui/document/text.h"

#include "core/base/parallel.h"

#include <system_error>
#include <utility>

#include <QLocale>
#include <QStringList>

namespace fumage::ui {

ExportWorker::ExportWorker(QObject* parent)
    : QObject(parent)
{
}

void ExportWorker::start(std::shared_ptr<const ExportJob> job, std::shared_ptr<AirCache> shelf)
{
    if (isRunning()) {
        return;
    }
    m_job = std::move(job);
    m_timer.start();
    m_hasBegun = false;
    const auto work = [this, job = m_job, shelf = std::move(shelf)](const std::stop_token& stop) {
        const auto progress = [this](ProgressPhase part, int done, int total) {
            QMetaObject::invokeMethod(
                this, [this, part, done, total] { report(part, done, total); }, Qt::QueuedConnection);
        };
        Result<std::optional<Flipbook>> result = std::optional<Flipbook>();
        runBehindOthers([&] { result = runJob(*job, {{progress, stop}, shelf}); });
        endSoon(result);
    };
    try {
        m_thread = GuardedThread(work, [this](const Error& why) { endSoon(why); });
    } catch (const std::system_error&) {
        end(Error{ErrorCode::OutOfMemory,
            makeMessage("the export cannot be started: there are not enough memory or threads"), {},
            makeMessage("Close other programs")});
    }
}

void ExportWorker::report(ProgressPhase work, int done, int total)
{
    if (work == ProgressPhase::Frames) {
        m_hasBegun = true;
        constexpr double kMillisecondsASecond = 1000.0;
        const double elapsed = static_cast<double>(m_timer.elapsed()) / kMillisecondsASecond;
        emit progressed(done, total, done > 0 ? elapsed / done * (total - done) : -1.0);
    } else if (!m_hasBegun) {
        m_timer.restart();
        const int percent = static_cast<int>(100.0 * done / total);
        switch (work) {
        case ProgressPhase::Air: emit preparing(tr("Baking the air: %1 %").arg(percent)); break;
        case ProgressPhase::Fitting: emit preparing(tr("Looking where the smoke is: %1 %").arg(percent)); break;
        default: emit preparing(tr("Simulating what comes before: %1 %").arg(percent)); break;
        }
    }
}

void ExportWorker::cancel()
{
    m_thread.requestStop();
}

void ExportWorker::endSoon(const Result<std::optional<Flipbook>>& result)
{
    QMetaObject::invokeMethod(
        this, [this, result] { end(result); }, Qt::QueuedConnection);
}

void ExportWorker::end(const Result<std::optional<Flipbook>>& result)
{
    const std::shared_ptr<const ExportJob> job = std::exchange(m_job, nullptr);
    if (result) {
        emit finished(
            result.value() && result.value()->cutOff ? complaint(*result.value()->cutOff, job->plan) : QString());
    } else if (result.error().code == ErrorCode::Cancelled) {
        emit cancelled();
    } else {
        emit failed(translated(result.error()));
    }
}

QString ExportWorker::complaint(const CutOff& cut, const ExportPlan& plan)
{
    QStringList edges;
    for (const auto& [reached, name] : {std::pair{cut.left, tr("left")}, std::pair{cut.right, tr("right")},
             std::pair{cut.top, tr("top")}, std::pair{cut.bottom, tr("bottom")}}) {
        if (reached) {
            edges << name;
        }
    }
    if (plan.fitCamera && plan.outlierPercent > 0.0F) {
        return tr("Outliers are cut off at the edge of cells (%1) in frames %2 to %3.")
            .arg(edges.join(QStringLiteral(", ")))
            .arg(cut.firstFrame)
            .arg(cut.lastFrame);
    }
    const QString what = cut.distance > 0.0F
        ? tr("The smoke is cut off at the edge of cells (%1) in frames %2 to %3. Fit the camera, or move it back to %4 "
             "m.")
        : tr("The smoke is cut off at the edge of cells (%1) in frames %2 to %3. Fit the camera.");
    const QString told = what.arg(edges.join(QStringLiteral(", "))).arg(cut.firstFrame).arg(cut.lastFrame);
    return cut.distance > 0.0F ? told.arg(QLocale().toString(cut.distance, 'g', 3)) : told;
}

} // namespace fumage::ui
