#include "ui/presets/loop_player.h"

#include "ui/presets/thumbnailer.h"

#include "core/base/parallel.h"

#include <utility>

namespace fumage::ui {

LoopPlayer::LoopPlayer(std::optional<ThumbnailStore> store, QObject* parent)
    : QObject(parent)
    , m_store(std::move(store))
{
    m_tick.setInterval(kFrameMs);
    connect(&m_tick, &QTimer::timeout, this, [this] {
        m_at = (m_at + 1) % m_loop.size();
        emit moved(m_name);
    });
}

void LoopPlayer::start(const QString& name, const Scene& scene, int edge)
{
    if (name == m_name) {
        return;
    }
    stop();
    m_name = name;
    m_job.ask(
        [this, scene, edge](const AsyncRequest::Report& report, const std::stop_token& stop) {
            std::vector<QImage> loop = m_store ? m_store->findLoop(scene, edge, kFrames) : std::vector<QImage>();
            const bool isRendered = loop.empty();
            if (isRendered) {
                runBehindOthers([&] { loop = renderThumbnailLoop(scene, edge, kFrames, stop); });
                if (m_store && !loop.empty()) {
                    m_store->putLoop(scene, edge, loop);
                }
            }
            report([this, loop = std::move(loop), isRendered] { take(loop, isRendered); });
        },
        [](const Error&) {}); // it stands still
}

void LoopPlayer::take(std::vector<QImage> loop, bool isRendered)
{
    m_loop = std::move(loop);
    m_rendered += isRendered ? 1 : 0;
    m_at = 0;
    if (!m_loop.empty()) {
        m_tick.start();
        emit moved(m_name);
    }
}

void LoopPlayer::stop()
{
    const QString name = std::exchange(m_name, {});
    m_job.forget();
    m_tick.stop();
    m_loop.clear();
    if (!name.isEmpty()) {
        emit moved(name);
    }
}

QImage LoopPlayer::frame() const
{
    return m_loop.empty() ? QImage() : m_loop[m_at];
}

} // namespace fumage::ui
