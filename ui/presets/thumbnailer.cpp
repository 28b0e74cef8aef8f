#include "ui/presets/thumbnailer.h"

#include "ui/preview/preview_renderer.h"
#include "ui/presets/shipped_thumbnails.h"

#include <algorithm>

namespace fumage::ui {

namespace {

/// Enough for a picture of a hand's width, few enough for a dozen of them in a second.
constexpr int kParticles = 16000;
/// Of the air, along its longest side: another flow than the whole, but of the same kind, in half a second instead of
/// many.
constexpr int kAirCells = 32;

/// A burst is at its best soon after it, steady smoke when it has been rising for a while.
int tellingFrame(const Effect& effect)
{
    const double life = static_cast<double>(effect.life.initialAlpha / effect.life.fadeRate);
    const double seconds = effect.emitter.mode == EmissionMode::Burst
        ? std::min(0.4 * life, static_cast<double>(effect.emitter.burstDuration) + 0.8)
        : life;
    const double ofFilm = seconds / static_cast<double>(effect.timeline.timeScale);
    return std::clamp(static_cast<int>(ofFilm * effect.timeline.frameRate), 0, std::max(0, effect.timeline.length - 1));
}

/// What is rendered in place of a scene: few particles, coarse air.
RenderRequest requestFor(const Scene& scene, int edge)
{
    Scene preview = scene;
    std::vector<SampledEffect> thin = sampledLayers(scene);
    thinLayers(thin, kParticles);
    const std::vector<std::size_t> visible = scene.visibleLayers();
    for (std::size_t i = 0; i < visible.size(); ++i) {
        preview.layers[visible[i]].emitter = thin[i]->emitter;
        preview.layers[visible[i]].look = thin[i]->look;
    }
    preview.output.quality = Quality::Good;
    preview.output.width = edge;
    preview.output.height = edge;
    preview.air.resolution = std::min(preview.air.resolution, kAirCells);
    RenderRequest request;
    request.scene = std::make_shared<const Scene>(preview);
    request.width = edge;
    request.height = edge;
    return request;
}

} // namespace

QImage renderThumbnail(const Scene& scene, int edge, const std::stop_token& stop)
{
    RenderRequest request = requestFor(scene, edge);
    request.frame = tellingFrame(request.scene->effect());
    const PicturePtr picture = PreviewRenderer().make(request, stop);
    return picture ? picture->image : QImage();
}

std::vector<QImage> renderThumbnailLoop(const Scene& scene, int edge, int frames, const std::stop_token& stop)
{
    RenderRequest request = requestFor(scene, edge);
    PreviewRenderer renderer; // goes on from frame to frame
    std::vector<QImage> loop;
    const int length = std::max(1, scene.timeline.length);
    for (int i = 0; i < frames; ++i) {
        request.frame = static_cast<int>(std::int64_t{i} * length / frames);
        ++request.revision;
        const PicturePtr picture = renderer.make(request, stop);
        if (!picture || stop.stop_requested()) {
            return {};
        }
        loop.push_back(picture->image);
    }
    return loop;
}

bool showsSomething(const QImage& image)
{
    double sum = 0.0;
    double squares = 0.0;
    const QImage grey = image.convertToFormat(QImage::Format_Grayscale8);
    for (int y = 0; y < grey.height(); ++y) {
        for (int x = 0; x < grey.width(); ++x) {
            const double value = grey.constScanLine(y)[x];
            sum += value;
            squares += value * value;
        }
    }
    const double count = std::max(1.0, static_cast<double>(grey.width()) * grey.height());
    const double mean = sum / count;
    constexpr double kMinDeviation = 3.0; // of 255: less is not seen at this size
    return squares / count - mean * mean > kMinDeviation * kMinDeviation;
}

Thumbnailer::Thumbnailer(std::optional<ThumbnailStore> store, QObject* parent)
    : QObject(parent)
    , m_store(std::move(store))
    , m_thread([this](const std::stop_token& stop) { run(stop); }, &Thumbnailer::complain)
{
}

Thumbnailer::~Thumbnailer()
{
    m_thread.requestStop();
}

void Thumbnailer::request(const QString& name, const Scene& scene, int edge)
{
    const std::lock_guard lock(m_mutex);
    const auto same = std::find_if(m_jobs.begin(), m_jobs.end(), [&](const Job& job) { return job.name == name; });
    if (same != m_jobs.end()) {
        *same = {name, scene, edge, false};
    } else {
        // What is at hand does not wait for what has to be rendered.
        const bool isAtHand = isThumbnailShipped(scene);
        const auto place = isAtHand
            ? std::find_if(m_jobs.begin(), m_jobs.end(), [](const Job& job) { return !job.isAtHand; })
            : m_jobs.end();
        m_jobs.insert(place, {name, scene, edge, isAtHand});
    }
    m_wake.notify_one();
}

void Thumbnailer::clear()
{
    const std::lock_guard lock(m_mutex);
    m_jobs.clear();
}

QImage Thumbnailer::pictureOf(const Job& job, const std::stop_token& stop) const
{
    QImage image = m_store ? m_store->find(job.scene, job.edge) : QImage();
    if (image.isNull()) {
        image = shippedThumbnail(job.scene, job.edge);
    }
    if (!image.isNull()) {
        return image;
    }
    image = renderThumbnail(job.scene, job.edge, stop);
    if (m_store && !image.isNull()) {
        m_store->put(job.scene, job.edge, image);
    }
    return image;
}

/// What has no picture is shown without one: nobody has to be told in the middle of something else.
void Thumbnailer::complain(const Error& why)
{
    qWarning("A thumbnail cannot be made: %s", why.text().c_str());
}

void Thumbnailer::run(const std::stop_token& stop)
{
    if (m_store) {
        runGuarded([this] { m_store->prune(); }, &Thumbnailer::complain);
    }
    while (!stop.stop_requested()) {
        Job job;
        {
            std::unique_lock lock(m_mutex);
            if (!m_wake.wait(lock, stop, [this] { return !m_jobs.empty(); })) {
                return;
            }
            job = std::move(m_jobs.front());
            m_jobs.pop_front();
        }
        QImage image;
        runGuarded([&] { image = pictureOf(job, stop); }, &Thumbnailer::complain);
        if (!image.isNull()) {
            QMetaObject::invokeMethod(
                this, [this, name = job.name, image] { emit ready(name, image); }, Qt::QueuedConnection);
        }
    }
}

} // namespace fumage::ui
