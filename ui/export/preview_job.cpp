#include "ui/export/preview_job.h"

#include "ui/document/text.h"

namespace fumage::ui {

namespace {

constexpr int kMaxEdge = 320; ///< of a cell, pixels: about as large as it is shown
constexpr std::int64_t kMaxPixels = std::int64_t{1} << 23U; ///< 128 MiB of colour

} // namespace

PreviewJob::PreviewJob(std::shared_ptr<AirCache> shelf, QObject* parent)
    : QObject(parent)
    , m_shelf(std::move(shelf))
{
}

void PreviewJob::start(const Scene& scene, const ExportPlan& plan)
{
    m_job.ask(
        [this, scene, plan](const AsyncRequest::Report& report, const std::stop_token& stop) {
            const auto progress = [&](ProgressPhase part, int done, int total) {
                if (part == ProgressPhase::Frames) {
                    constexpr int kPercent = 100;
                    report([this, percent = kPercent * done / total] { emit progressed(percent); });
                }
            };
            const Result<std::shared_ptr<const SheetPreview>> preview =
                previewFlipbook(scene, plan, kMaxEdge, kMaxPixels, {{progress, stop}, m_shelf});
            if (preview) {
                report([this, made = preview.value()] { emit ready(made); });
            } else if (preview.error().code != ErrorCode::Cancelled) {
                report([this, message = translated(preview.error())] { emit failed(message); });
            }
        },
        [this](const Error& why) { emit failed(translated(why)); });
}

} // namespace fumage::ui
