#include "ui/export/sheet_search.h"

#include "ui/document/text.h"

#include "core/base/parallel.h"

namespace fumage::ui {

SheetSearch::SheetSearch(QObject* parent)
    : QObject(parent)
{
}

void SheetSearch::start(const Scene& scene, const ExportPlan& plan, std::int64_t budget)
{
    m_job.ask(
        [this, scene, plan, budget](const AsyncRequest::Report& report, const std::stop_token& stop) {
            const auto progress = [&](ProgressPhase part, int done, int total) {
                if (part == ProgressPhase::Frames) {
                    report([this, share = static_cast<double>(done) / total] { emit progressed(share); });
                }
            };
            Result<std::vector<SheetCandidate>> rated = std::vector<SheetCandidate>();
            runBehindOthers([&] { rated = rateSheets(scene, plan, budget, {progress, stop}); });
            if (rated) {
                report([this, best = bestOf(rated.value())] { emit found(best); });
            } else if (rated.error().code != ErrorCode::Cancelled) {
                report([this, message = translated(rated.error())] { emit failed(message); });
            }
        },
        [this](const Error& why) { emit failed(translated(why)); });
}

} // namespace fumage::ui
