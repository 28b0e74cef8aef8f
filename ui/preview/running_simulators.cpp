#include "ui/preview/running_simulators.h"

#include <algorithm>
#include <utility>

namespace fumage::ui {

double RunningSimulator::stepsEach(int frame) const
{
    double steps = 0.0;
    for (std::size_t layer = 0; layer < simulator.layers(); ++layer) {
        steps += simulator.particleSteps(layer, frame);
    }
    return steps / std::max(1, particles);
}

const RunningSimulator* RunningSimulators::complete(const PicturePlan& plan) const
{
    const std::optional<RunningSimulator>& running = m_all[Complete];
    return running && running->isFor(plan) ? &*running : nullptr;
}

RunningSimulators::Place RunningSimulators::placeFor(const PicturePlan& plan)
{
    return plan.keepsAll ? Complete : plan.settles ? Settling : Thinned;
}

RunningSimulator RunningSimulators::made(const PicturePlan& plan, std::optional<RunningSimulator>& before) const
{
    // What cannot be seen needs no checkpoints to come back to.
    const std::size_t checkpoints = plan.keepsAll ? Simulator::kDefaultCheckpointBytes : 0;
    RunningSimulator running{
        plan.simulation, plan.particles, plan.coarseAir, SceneSimulator(plan.layers, checkpoints, m_shelf)};
    if (before) {
        running.simulator.adopt(before->simulator, plan.muted);
    }
    return running;
}

RunningSimulator& RunningSimulators::runningFor(const PicturePlan& plan)
{
    std::optional<RunningSimulator>& running = m_all[placeFor(plan)];
    if (!running || !running->isFor(plan)) {
        running = made(plan, running);
    }
    return *running;
}

void RunningSimulators::renew(const PicturePlan& plan)
{
    std::optional<RunningSimulator>& running = m_all[Complete];
    if (running && running->simulation != plan.simulation) {
        running = made(plan, running);
    }
}

void RunningSimulators::take(const PicturePlan& plan, SceneSimulator simulator)
{
    m_all[Complete] = RunningSimulator{plan.simulation, plan.particles, plan.coarseAir, std::move(simulator)};
    m_all[Settling].reset();
}

double RunningSimulators::stepsEach(const PicturePlan& plan, int frame, double preRoll) const
{
    const std::optional<RunningSimulator>& running = m_all[placeFor(plan)];
    return running && running->isFor(plan) ? running->stepsEach(frame) : preRoll;
}

} // namespace fumage::ui
