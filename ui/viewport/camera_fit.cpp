#include "ui/viewport/camera_fit.h"

#include "ui/document/text.h"
#include "ui/viewport/navigation.h"

#include "core/export/fit_camera.h"

namespace fumage::ui {

namespace {

constexpr int kShownMs = 8000;

} // namespace

CameraFit::CameraFit(Document& document, std::shared_ptr<AirCache> shelf)
    : m_document(document)
    , m_shelf(std::move(shelf))
    , m_job([this](const Request& request, const std::stop_token& stop) { work(request, stop); },
          [this](const Request& request, const Error& why) { report(request, [this, why] { end(why); }); })
{
    connect(&m_document, &Document::effectChanged, this, [this](const EffectChange& change) {
        if (m_running && change.isOfScene) { // all frames are looked at, whichever is shown
            post();
        }
    });
    connect(&m_document, &Document::loaded, this, [this] {
        if (m_running) {
            m_running = false;
            emit news({}, kShownMs);
            emit ended();
        }
    });
}

void CameraFit::start(float outliers)
{
    m_outliers = outliers;
    m_running = true;
    post();
}

void CameraFit::post()
{
    m_job.post({m_document.scene(), m_outliers, ++m_number});
}

void CameraFit::report(const Request& request, std::function<void()> news)
{
    QMetaObject::invokeMethod(
        this,
        [this, number = request.number, news = std::move(news)] {
            if (m_running && number == m_number) {
                news();
            }
        },
        Qt::QueuedConnection);
}

void CameraFit::work(const Request& request, const std::stop_token& stop)
{
    constexpr int kPercent = 100;
    int told = -1;
    const auto progress = [&](int done, int total) {
        if (const int percent = kPercent * done / total; percent > told) {
            told = percent;
            report(
                request, [this, percent] { emit news(tr("Looking for smoke in all frames: %1 %").arg(percent), 0); });
        }
    };
    const Result<Camera> camera = fitCamera(
        request.scene, {0, request.scene.timeline.length - 1, 1}, request.outliers, {{progress, stop}, m_shelf});
    report(request, [this, camera] { end(camera); });
}

void CameraFit::end(const Result<Camera>& camera)
{
    m_running = false;
    if (camera) {
        m_document.moveCamera(camera.value());
        emit news(m_outliers > 0.0F ? tr("The camera shows the smoke of the animation without outliers")
                                    : tr("The camera shows all smoke of the animation"),
            kShownMs);
    } else {
        emit news(translated(camera.error()), kShownMs);
    }
    emit ended();
}

} // namespace fumage::ui
