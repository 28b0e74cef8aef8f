#include "tests/benchmarks/measure.h"
#include "tests/live/restless_game.h"

#include "core/base/parallel.h"
#include "core/simulation/advance.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>

#include <unistd.h>

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
    const std::int64_t lifetime = SimulationModel(sampled(effect)).schedule().lifetimeSteps;
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
    const SimulationModel model(sampled(inGame(particles)));
    Particles moved;
    std::int64_t at = model.schedule().lifetimeSteps;
    (void)advanceFromNothing(model, moved, at);
    for (auto _ : state) {
        (void)advance(model, moved, at, at + 1);
        ++at;
    }
}

/// What the light of a game's smoke costs beside its steps: as it is seen from another place each time.
void light(benchmark::State& state, int particles, int resolution, bool withNormals, float multiple = 0.0F)
{
    const ThreadLimit one(1);
    Effect effect = inGame(particles);
    effect.air.enabled = false;
    effect.light.resolution = resolution;
    effect.light.multipleScattering = multiple;
    Result<LiveSimulation> made = LiveSimulation::start(effect);
    if (!made) {
        state.SkipWithError(made.error().text().c_str());
        return;
    }
    LiveSimulation& live = made.value();
    for (int i = 0; i < 200; ++i) {
        (void)live.step(live.stepSeconds());
    }
    float turn = 0.0F;
    for (auto _ : state) {
        benchmark::DoNotOptimize(live.litColours(glm::vec3(0.0F, 2.0F, turn += 0.01F)).ok());
        if (withNormals) {
            benchmark::DoNotOptimize(live.normals().ok());
        }
    }
}

/// Memory that the program holds, MiB.
double memoryNow()
{
    std::ifstream pages("/proc/self/statm");
    double whole = 0.0;
    double resident = 0.0;
    pages >> whole >> resident;
    constexpr double kMiB = 1048576.0;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / kMiB;
}

/// Takes a sorted number that as large a share of them is below.
double quantile(const std::vector<double>& sorted, double share)
{
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

/// What the thread has computed, s: on a machine that others use as well a clock on the wall tells how long they have
/// taken.
double secondsOfThread()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double secondsOnWall()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// What the steps of a minute have taken.
struct Minute {
    static constexpr int kSteps = 3600;

    std::vector<double> own; ///< ms of the thread
    std::vector<double> wall; ///< ms
    double share = 0.0; ///< of births, mean
    double grown = 0.0; ///< memory since the tenth second, MiB
    bool isSound = true; ///< nothing was refused, has jumped, or is no number
};

/// A game that changes wind, rate, lifetime and its emitter's place at random.
Minute minuteOf(LiveSimulation& live)
{
    Minute out;
    tests::RestlessGame game(live.effect(), live.effect().emitter.count);
    Particles before = live.particles();
    const float swirls = 6.0F * live.effect().turbulence.strength; // their peak over their root mean square
    double settled = 0.0;
    for (int step = 0; step < Minute::kSteps; ++step) {
        before.copySlots(live.particles(), 0, before.x.size());
        const bool isTaken = game.act(live, step).ok();
        const double own = secondsOfThread();
        const double wall = secondsOnWall();
        const bool isDone = live.step(tests::kDt).ok();
        out.own.push_back(1e3 * (secondsOfThread() - own));
        out.wall.push_back(1e3 * (secondsOnWall() - wall));
        out.share += static_cast<double>(live.share()) / Minute::kSteps;
        settled = step == 600 ? memoryNow() : settled;
        out.isSound = out.isSound && isTaken && isDone && tests::isFinite(live.particles())
            && tests::longestJump(before, live.particles(), swirls) < 1e-4F;
    }
    out.grown = memoryNow() - settled;
    std::sort(out.own.begin(), out.own.end());
    std::sort(out.wall.begin(), out.wall.end());
    return out;
}

/// @param budgetMs of the thread's own time
void minute(benchmark::State& state, const Effect& effect, double budgetMs)
{
    const ThreadLimit one(1);
    for (auto _ : state) {
        Result<LiveSimulation> live = LiveSimulation::start(effect, {.budgetMs = budgetMs, .clock = secondsOfThread});
        const Minute taken = live ? minuteOf(live.value()) : Minute{.isSound = false};
        if (!taken.isSound) {
            state.SkipWithError("a step was refused, has jumped or has no numbers");
            return;
        }
        state.counters["p50ms"] = quantile(taken.own, 0.5);
        state.counters["p99ms"] = quantile(taken.own, 0.99);
        state.counters["most_ms"] = taken.own.back();
        state.counters["wall_p99ms"] = quantile(taken.wall, 0.99);
        state.counters["share"] = taken.share;
        state.counters["MiB_more"] = taken.grown;
    }
}

/// Smoke that is several times too large for its budget.
void addMinutes(std::vector<Claim>& claims)
{
    const auto add = [&](const std::string& name, const std::string& what, const Effect& effect, double budgetMs) {
        benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { minute(state, effect, budgetMs); })
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond)
            ->Iterations(1);
        claims.push_back({what + ", 99 of 100 steps", name, "", "p99ms", budgetMs, true});
        claims.push_back({"  half of them", name, "", "p50ms"});
        claims.push_back({"  all", name, "", "most_ms"});
        claims.push_back({"  on the wall, with what others took of the machine", name, "", "wall_p99ms"});
        claims.push_back({"  mean share of births", name, "", "share"});
        claims.push_back({"  memory that the last 50 s took more", name, "", "MiB_more", 1.0, true});
    };
    Effect inAir = tests::inAir(400000);
    inAir.air.resolution = 24;
    add("live/minute", "a restless minute", tests::windy(200000), 2.0);
    add("live/minute_air", "a restless minute in air", inAir, 4.0);
}

} // namespace

void addLiveBenchmarks(std::vector<Claim>& claims)
{
    const auto add = [](const std::string& name, const auto& run) {
        benchmark::RegisterBenchmark(name.c_str(), run)->UseRealTime()->Unit(benchmark::kMicrosecond);
    };
    for (const int count : {16, 10000}) {
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
    for (const int resolution : {16, 32, 64}) {
        const std::string name = "live/light_" + std::to_string(resolution);
        add(name, [=](benchmark::State& state) { light(state, 20000, resolution, false); });
        add(name + "_normals", [=](benchmark::State& state) { light(state, 20000, resolution, true); });
        add(name + "_multiple", [=](benchmark::State& state) { light(state, 20000, resolution, false, 1.0F); });
        const std::string what = "light on 20000 live particles, " + std::to_string(resolution) + " cells, 1 thread";
        claims.push_back({what, name, "", ""});
        claims.push_back({"  and their normals", name + "_normals", "", ""});
        claims.push_back({"  with multiple scattering, over without", name, name + "_multiple", ""});
    }
    addMinutes(claims);
}

} // namespace fumage::benchmarks
