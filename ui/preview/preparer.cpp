#include "ui/preview/preparer.h"

#include <algorithm>

namespace fumage::ui {

Preparer::Preparer(std::shared_ptr<AirCache> shelf, QObject* parent)
    : QObject(parent)
    , m_shelf(std::move(shelf))
    , m_job([this](const Request& request, const std::stop_token& stop) { work(request, stop); },
          [this](const Request& request, const Error&) { finish(request, nullptr); }) // what plays goes on without
{
}

void Preparer::prepare(std::shared_ptr<const Scene> scene, quint64 simulation, int frame)
{
    setFrame(frame);
    if (m_busy && simulation == m_simulation) {
        return;
    }
    m_busy = true;
    m_simulation = simulation;
    m_job.post({std::move(scene), simulation});
}

void Preparer::stop()
{
    if (m_busy) {
        m_busy = false;
        m_job.post({}); // which stops what is being done
    }
}

void Preparer::report(Phase phase, double share)
{
    QMetaObject::invokeMethod(
        this,
        [this, phase, share] {
            if (m_busy) {
                emit working(phase, share);
            }
        },
        Qt::QueuedConnection);
}

void Preparer::work(const Request& request, const std::stop_token& stop)
{
    if (request.scene) {
        std::shared_ptr<SceneSimulator> simulator = simulatorAtFrame(request, stop);
        if (!stop.stop_requested()) {
            finish(request, std::move(simulator));
        }
    }
}

std::shared_ptr<SceneSimulator> Preparer::simulatorAtFrame(const Request& request, const std::stop_token& stop)
{
    Scene scene = *request.scene;
    scene.output.quality = std::min(scene.output.quality, Quality::Good); // as pictures that are played have it
    auto simulator =
        std::make_shared<SceneSimulator>(sampledLayers(scene), Simulator::kDefaultCheckpointBytes, m_shelf);
    constexpr int kBehind = 2; // frames that whoever plays takes no notice of
    while (true) {
        const int frame = m_frame.load();
        const auto progress = [this](ProgressPhase work, int done, int total) {
            report(
                work == ProgressPhase::Air ? Phase::Air : Phase::Steps, static_cast<double>(done) / std::max(1, total));
        };
        if (!simulator->frame(frame, {progress, stop})) {
            return nullptr;
        }
        const int ahead = m_frame.load() - frame;
        if (ahead >= 0 && ahead <= kBehind) {
            return simulator;
        }
    }
}

void Preparer::finish(const Request& request, std::shared_ptr<SceneSimulator> simulator)
{
    QMetaObject::invokeMethod(
        this,
        [this, simulation = request.simulation, simulator = std::move(simulator)] {
            if (!m_busy || simulation != m_simulation) {
                return; // something else is wanted by now
            }
            m_busy = false;
            if (simulator) {
                emit prepared(simulator, simulation);
            }
            emit ended(simulator != nullptr);
        },
        Qt::QueuedConnection);
}

} // namespace fumage::ui
