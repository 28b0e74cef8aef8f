#include "core/simulation/scene_simulator.h"

#include "core/effect/parameter_table.h"
#include "core/simulation/air_plan.h"

#include <algorithm>
#include <iterator>

namespace fumage {

namespace {

/// Whether two effects move their particles alike: they may differ in their look alone.
bool movesAlike(const SampledEffect& one, const SampledEffect& other)
{
    const auto isSame = [](const Track* track, const Track* same) {
        return track != nullptr && same != nullptr ? *track == *same : track == same;
    };
    const std::span<const Parameter> rows = parameterTable();
    return std::all_of(rows.begin(), rows.end(), [&](const Parameter& row) {
        return row.dirties < DirtyStage::Simulate
            || (row.get(one) == row.get(other) && isSame(one.track(row), other.track(row)));
    });
}

bool simulatesAlike(const SimulationModel& one, const SimulationModel& other)
{
    if (one.parent() && other.parent() && !simulatesAlike(*one.parent(), *other.parent())) {
        return false;
    }
    return (one.parent() == nullptr) == (other.parent() == nullptr) && one.air() == other.air()
        && one.clock() == other.clock() && movesAlike(one.effect(), other.effect());
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

/// Most particles that the layers of a scene are born on, in all: about 4 GB. Each layer has those of its own, and
/// those that they are born on.
constexpr std::int64_t kMaxParents = std::int64_t{16} * kMaxParticles;

Status checkParents(SampledLayers layers)
{
    std::int64_t particles = 0;
    for (const SampledEffect& layer : layers) {
        for (const SampledEffect* parent = layer.parent().get(); parent != nullptr; parent = parent->parent().get()) {
            particles += (*parent)->emitter.count;
        }
    }
    if (particles <= kMaxParents) {
        return Done{};
    }
    return Error{ErrorCode::TooLarge,
        makeMessage(
            "layers are born on %1 particles of others in all, at most %2 are possible", particles, kMaxParents),
        std::string("emitter.count"), makeMessage("Give fewer particles to the layers that others are born on")};
}

Status checkLayers(SampledLayers layers)
{
    Status status = checkParents(layers);
    return status ? checkAir(layers) : status;
}

} // namespace

SceneSimulator::SceneSimulator(
    SampledLayers layers, std::size_t checkpointBytes, const std::shared_ptr<AirCache>& shelf)
    : m_status(checkLayers(layers))
{
    const std::shared_ptr<BakedAir> air = m_status ? airFor(layers, shelf) : nullptr;
    for (const SampledEffect& layer : layers) {
        m_layers.emplace_back(modelOf(layers, layer, air), checkpointBytes / layers.size());
    }
}

void SceneSimulator::adopt(SceneSimulator& other, SampledLayers muted)
{
    std::vector<Simulator> left = std::move(other.m_layers);
    std::move(other.m_muted.begin(), other.m_muted.end(), std::back_inserter(left));
    for (Simulator& layer : m_layers) {
        const auto same = std::find_if(left.begin(), left.end(),
            [&](const Simulator& each) { return simulatesAlike(each.model(), layer.model()); });
        if (same != left.end()) {
            std::swap(*same, layer);
        }
    }
    for (const SampledEffect& layer : muted) {
        const auto same = std::find_if(left.begin(), left.end(), [&](const Simulator& each) {
            return each.model().air() == model().air() && movesAlike(each.model().effect(), layer);
        });
        if (same != left.end()) {
            m_muted.push_back(std::move(*same));
            left.erase(same);
        }
    }
}

double SceneSimulator::particleSteps(std::size_t layer, int number) const
{
    const Simulator& simulator = m_layers[layer];
    return static_cast<double>(simulator.model().effect()->emitter.count) * simulator.stepsTo(number);
}

Result<SceneFrame> SceneSimulator::frame(int number, const Task& task)
{
    if (!m_status) {
        return m_status.error();
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
