#include "tests/benchmarks/measure.h"
#include "tests/effects.h"

#include "core/base/parallel.h"
#include "core/live/live_simulation.h"
#include "core/simulation/advance.h"

#include <cmath>

namespace fumage::benchmarks {

namespace {

/// The default look at a game's rate.
Effect inGame(int particles)
{
    Effect effect;
    effect.emitter.count = particles;
    effect.timeline.frameRate = 60;
    effect.timeline.loop = false;
    effect.timeline.prewarm = false;
    return effect;
}

/// Where the emitter of a step is.
enum class Way {
    Still,
    Circle,
    StillAndSet ///< and the effect is set in each step, for which the model is made anew
};

EmitterPose onCircle(int step)
{
    const float angle = 0.02F * static_cast<float>(step);
    return {{std::cos(angle), 0.0F, std::sin(angle)}, {0.0F, 1.0F, 0.0F}, glm::vec3(0.0F)};
}

void step(benchmark::State& state, int particles, Way way)
{
    const ThreadLimit one(1);
    const Effect effect = inGame(particles);
    Result<LiveSimulation> made = LiveSimulation::start(effect);
    if (!made) {
        state.SkipWithError(made.error().text().c_str());
        return;
    }
    LiveSimulation& live = made.value();
    const std::int64_t lifetime = Model(sampled(effect)).schedule().lifetimeSteps;
    for (std::int64_t i = 0; i < lifetime; ++i) {
        (void)live.step(live.stepSeconds());
    }
    int number = 0;
    for (auto _ : state) {
        if (way == Way::Circle) {
            (void)live.setEmitter(onCircle(++number));
        } else if (way == Way::StillAndSet) {
            (void)live.setEffect(effect);
        }
        (void)live.step(live.stepSeconds());
    }
}

/// The same particles by the simulator, which knows all of its effect beforehand.
void advanceAlone(benchmark::State& state, int particles)
{
    const ThreadLimit one(1);
    const Model model(sampled(inGame(particles)));
    Particles moved;
    std::int64_t at = model.schedule().lifetimeSteps;
    (void)advanceFromNothing(model, moved, at);
    for (auto _ : state) {
        (void)advance(model, moved, at, at + 1);
        ++at;
    }
}

} // namespace

void addLiveBenchmarks(std::vector<Claim>& claims)
{
    const auto add = [](const std::string& name, const auto& run) { benchmark::RegisterBenchmark(name.c_str(), run)->UseRealTime()->Unit(benchmark::kMicrosecond); };
    for (const int count : {256, 10000}) {
        const std::string name = "live/" + std::to_string(count);
        add(name + "_still", [=](benchmark::State& state) { step(state, count, Way::Still); });
        add(name + "_circle", [=](benchmark::State& state) { step(state, count, Way::Circle); });
        add(name + "_set", [=](benchmark::State& state) { step(state, count, Way::StillAndSet); });
        add(name + "_advance", [=](benchmark::State& state) { advanceAlone(state, count); });
        claims.push_back({std::to_string(count) + " live particles, a step, 1 thread", name + "_still", "", ""});
        claims.push_back({"  while the emitter moves", name + "_circle", "", ""});
        claims.push_back({"  over one whose model is made anew", name + "_still", name + "_set", ""});
        claims.push_back({"  over a step of the simulator", name + "_still", name + "_advance", ""});
    }
}

} // namespace fumage::benchmarks
