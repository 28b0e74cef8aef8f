#include "ui/export/preview_job.h"

#include "ui/document/text.h"

namespace fumage::ui {

namespace {

constexpr int kMostEdge = 320; ///< of a cell, pixels: about as large as it is shown
constexpr std::int64_t kMostPixels = std::int64_t{1} << 23U; ///< 128 MiB of colour

} // namespace

PreviewJob::PreviewJob(QObject* parent)
    : QObject(parent)
    , m_job([this](const Request& request, const std::stop_token& stop) { make(request, stop); })
{
}

void PreviewJob::start(const Effect& effect, const ExportPlan& plan)
{
    m_job.post({++m_number, std::pair{effect, plan}});
}

void PreviewJob::stop()
{
    m_job.post({++m_number, std::nullopt});
}

void PreviewJob::make(const Request& request, const std::stop_token& stop)
{
    if (!request.flipbook) {
        return;
    }
    const auto later = [this, number = request.number](const auto& say) {
        QMetaObject::invokeMethod(
            this,
            [this, number, say] {
                if (number == m_number) {
                    say();
                }
            },
            Qt::QueuedConnection);
    };
    const auto report = [&](Work part, int done, int total) {
        if (part == Work::Frames) {
            constexpr int kPercent = 100;
            later([this, percent = kPercent * done / total] { emit progressed(percent); });
        }
    };
    const Result<std::shared_ptr<const SheetPreview>> preview = previewFlipbook(request.flipbook->first, request.flipbook->second, kMostEdge, kMostPixels, report, stop);
    if (preview) {
        later([this, made = preview.value()] { emit ready(made); });
    } else if (preview.error().code != ErrorCode::Cancelled) {
        later([this, message = told(preview.error())] { emit failed(message); });
    }
}

} // namespace fumage::ui
