#include "ui/export/preview_job.h"

#include "ui/document/text.h"

namespace fumage::ui {

namespace {

constexpr int kMostEdge = 320; ///< of a cell, pixels: about as large as it is shown
constexpr std::int64_t kMostPixels = std::int64_t{1} << 23U; ///< 128 MiB of colour

} // namespace

PreviewJob::PreviewJob(QObject* parent)
    : QObject(parent)
{
}

void PreviewJob::start(const Effect& effect, const ExportPlan& plan)
{
    m_job.ask([this, effect, plan](const AnswerJob::Tell& tell, const std::stop_token& stop) {
        const auto report = [&](Work part, int done, int total) {
            if (part == Work::Frames) {
                constexpr int kPercent = 100;
                tell([this, percent = kPercent * done / total] { emit progressed(percent); });
            }
        };
        const Result<std::shared_ptr<const SheetPreview>> preview = previewFlipbook(effect, plan, kMostEdge, kMostPixels, report, stop);
        if (preview) {
            tell([this, made = preview.value()] { emit ready(made); });
        } else if (preview.error().code != ErrorCode::Cancelled) {
            tell([this, message = told(preview.error())] { emit failed(message); });
        } },
        [this](const Error& why) { emit failed(told(why)); });
}

} // namespace fumage::ui
