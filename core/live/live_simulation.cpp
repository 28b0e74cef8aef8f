#include "core/live/live_simulation.h"

namespace fumage {

Result<LiveSimulation> LiveSimulation::start(const Effect& effect, const LiveOptions& options)
{
    Result<LiveScene> scene = LiveScene::start(effect, options);
    if (!scene) {
        return scene.error();
    }
    return LiveSimulation(std::move(scene).value());
}

LiveSimulation::LiveSimulation(LiveScene scene)
    : m_scene(std::move(scene))
    , m_effect(m_scene.scene().effect())
{
}

Status LiveSimulation::setEffect(const Effect& wanted)
{
    Status status = m_scene.setEffect(0, wanted);
    if (status) {
        m_effect = m_scene.scene().effect();
    }
    return status;
}

} // namespace fumage
