#include "core/export/farm/chunk.h"

#include "core/effect/sampling.h"
#include "core/simulation/air_plan.h"
#include "core/simulation/schedule.h"

#include <algorithm>

namespace fumage {

namespace {

// Seconds on two cores, as measured in resources/docs/performance.md, rounded.
constexpr double kPerCellStep = 23e-9;
constexpr double kPerParticleStep = 10e-9;
constexpr double kPerParticleDrawn = 250e-9;
constexpr double kPerPixel = 60e-9; ///< shaded, encoded and written
constexpr double kStart = 1.0; ///< a guess: queues of farms are looked at about once a second

} // namespace

double FarmCost::reach(int number) const
{
    const std::int64_t step = firstStep + number * stepsPerFrame;
    const std::int64_t airSteps = loopSteps > 0 ? firstStep + 2 * loopSteps : step;
    const std::int64_t particleSteps = std::min(step, lifetimeSteps);
    return start + static_cast<double>(airSteps) * airStep + static_cast<double>(particleSteps) * particleStep;
}

FarmCost farmCost(const Scene& scene)
{
    const std::vector<SampledEffect> layers = sampledLayers(scene);
    const Schedule schedule = makeSchedule(layers.front());
    double particles = 0.0;
    std::int64_t lifetime = 0;
    for (const SampledEffect& layer : layers) {
        const Schedule own = makeSchedule(layer);
        particles += static_cast<double>(own.capacity());
        lifetime = std::max(lifetime, own.lifetimeSteps);
    }
    const double edge = scene.output.supersample;
    const double pixels = static_cast<double>(scene.output.width) * scene.output.height * edge * edge;
    FarmCost cost;
    cost.start = kStart;
    cost.particleStep = particles * kPerParticleStep;
    cost.stepsPerFrame = schedule.stepsPerFrame;
    cost.firstStep = firstAirStep(layers);
    cost.loopSteps = schedule.loopSteps;
    cost.lifetimeSteps = lifetime;
    cost.frame = particles * kPerParticleDrawn + pixels * kPerPixel
        + static_cast<double>(schedule.stepsPerFrame) * cost.particleStep;
    if (scene.air.enabled && checkAir(layers)) {
        const glm::ivec3 cells = airGrid(layers).cells;
        int pieces = 1;
        for (const SampledEffect& layer : layers) {
            const bool acts = layer->emitter.mode == EmissionMode::Continuous;
            pieces = std::max(pieces, piecesOfStep(layer, schedule.dt, acts));
        }
        cost.airStep = static_cast<double>(cells.x) * cells.y * cells.z * pieces * kPerCellStep;
    }
    return cost;
}

int framesPerTask(const FarmCost& cost, const FrameRange& frames)
{
    const int fewest = (frames.count() + kMaxTasks - 1) / kMaxTasks;
    for (int perTask = fewest; perTask < frames.count(); ++perTask) {
        double reached = 0.0;
        for (int task = 0; task < taskCount(frames, perTask); ++task) {
            reached += cost.reach(framesOfTask(frames, perTask, task).first);
        }
        if (reached <= cost.frame * frames.count()) {
            return perTask;
        }
    }
    return frames.count();
}

FrameRange framesOfTask(const FrameRange& frames, int perTask, int task)
{
    const int first = task * perTask;
    return {frames.at(first), frames.at(std::min(first + perTask, frames.count()) - 1), frames.step};
}

int taskCount(const FrameRange& frames, int perTask)
{
    return (frames.count() + perTask - 1) / perTask;
}

} // namespace fumage
