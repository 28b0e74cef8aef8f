#include "core/simulation/scene_simulator.h"

#include "core/effect/parameter_table.h"
#include "core/simulation/air_plan.h"

#include <algorithm>

namespace fumage {

namespace {

/// Whether the particles of two models are the same: they may differ in their look alone.
bool simulatesAlike(const SimulationModel& one, const SimulationModel& other)
{
    if (one.air() != other.air() || one.clock() != other.clock() || (one.parent() && !other.parent())
        || (other.parent() && !one.parent())) {
        return false;
    }
    if (one.parent() && !simulatesAlike(*one.parent(), *other.parent())) {
        return false;
    }
    const std::span<const Parameter> rows = parameterTable();
    return std::all_of(rows.begin(), rows.end(), [&](const Parameter& row) {
        return row.dirties < DirtyStage::Simulate || row.get(one.effect()) == row.get(other.effect());
    });
}

/// The model of a layer, with those that it is born on.
std::shared_ptr<const SimulationModel> modelOf(
    SampledLayers layers, const SampledEffect& layer, const std::shared_ptr<BakedAir>& air)
{
    auto model = std::make_shared<SimulationModel>(layer, layerClock(layers, layer), air);
    if (layer.parent()) {
        model->setParent(modelOf(layers, *layer.parent(), air));
    }
    return model;
}

} // namespace

SceneSimulator::SceneSimulator(
    SampledLayers layers, std::size_t checkpointBytes, const std::shared_ptr<AirCache>& shelf)
    : m_airStatus(checkAir(layers))
{
    std::shared_ptr<BakedAir> air;
    if (m_airStatus) {
        air = shelf ? shelf->airOf(layers) : AirCache().airOf(layers);
    }
    for (const SampledEffect& layer : layers) {
        m_layers.emplace_back(modelOf(layers, layer, air), checkpointBytes / layers.size());
    }
}

void SceneSimulator::adopt(SceneSimulator& other)
{
    for (Simulator& layer : m_layers) {
        const auto same = std::find_if(other.m_layers.begin(), other.m_layers.end(),
            [&](const Simulator& each) { return simulatesAlike(each.model(), layer.model()); });
        if (same != other.m_layers.end()) {
            std::swap(*same, layer);
        }
    }
}

Result<SceneFrame> SceneSimulator::frame(int number, const Task& task)
{
    if (!m_airStatus) {
        return m_airStatus.error();
    }
    SceneFrame out;
    for (Simulator& layer : m_layers) {
        Result<std::shared_ptr<const Frame>> frame = layer.frame(number, task);
        if (!frame) {
            return frame.error();
        }
        out.layers.push_back(std::move(frame).value());
    }
    return out;
}

} // namespace fumage
