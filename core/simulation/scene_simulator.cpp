#include "core/simulation/scene_simulator.h"

#include "core/effect/parameter_table.h"
#include "core/simulation/air_plan.h"

#include <algorithm>

namespace fumage {

namespace {

/// Whether the particles of two models are the same: they may differ in their look alone.
bool simulatesAlike(const SimulationModel& one, const SimulationModel& other)
{
    if (one.air() != other.air() || one.clock() != other.clock()) {
        return false;
    }
    const std::span<const Parameter> rows = parameterTable();
    return std::all_of(rows.begin(), rows.end(), [&](const Parameter& row) {
        return row.dirties < DirtyStage::Simulate || row.get(one.effect()) == row.get(other.effect());
    });
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
    for (std::size_t i = 0; i < layers.size(); ++i) {
        m_layers.emplace_back(std::make_shared<const SimulationModel>(layers[i], layerClock(layers, i), air),
            checkpointBytes / layers.size());
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
