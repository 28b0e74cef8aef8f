#include "tests/benchmarks/measure.h"
#include "tests/benchmarks/obvious_air.h"
#include "tests/flow/flow_helpers.h"

#include "core/base/parallel.h"
#include "core/base/simd.h"
#include "core/simulation/advance.h"
#include "core/simulation/air_cache.h"

#include <array>
#include <cmath>

namespace fumage::benchmarks {

namespace {

constexpr float kHeight = 6.0F;

/// A plume that has risen for a second, so that there is something to move: step and what others read of it.
void airStep(benchmark::State& state, const glm::ivec3& cells, int threads, const std::string& simd)
{
    const ThreadLimit limit(threads);
    if (!forceSimdTarget(simd)) {
        state.SkipWithError("not on this machine");
        return;
    }
    const AirGrid grid = tests::boxOf(cells, kHeight);
    AirSolver air(grid, tests::onGround());
    AirStep step = tests::plumeStep(grid, 0.4F);
    step.confinement = 0.1F;
    tests::makeRagged(step, 0.3F, 0.0F);
    AirField field(grid);
    for (int i = 0; i < 30; ++i) {
        air.step(step);
    }
    for (auto _ : state) {
        air.step(step);
        air.read(field);
    }
    (void)forceSimdTarget("");
}

/// Air with a ball in it that goes to and fro, or stands.
void airAroundBall(benchmark::State& state, int cells, bool moves)
{
    const ThreadLimit limit(2);
    const AirGrid grid = tests::boxOf(glm::ivec3(cells), kHeight);
    const auto ballAt = [&](int step) {
        const float phase = moves ? 0.05F * static_cast<float>(step) : 0.0F;
        return Solid{
            SolidShape::Sphere, {1.5F * std::sin(phase), 0.5F * kHeight, 0.0F}, glm::vec3(0.2F * kHeight), {}, {}};
    };
    const std::array solids{ballAt(0)};
    AirSolver air(grid, tests::onGround(), solids);
    AirStep step = tests::plumeStep(grid, 0.4F);
    step.confinement = 0.1F;
    AirField field(grid);
    int at = 0;
    const auto next = [&] {
        ++at;
        if (moves) {
            step.obstacle = movedBetween(ballAt(at - 1), ballAt(at), step.dt);
        }
        air.step(step, field);
    };
    for (int i = 0; i < 30; ++i) {
        next();
    }
    for (auto _ : state) {
        next();
    }
}

void obviousAir(benchmark::State& state, const glm::ivec3& cells)
{
    ObviousAir air(cells.x, cells.y, cells.z, kHeight / static_cast<float>(cells.y));
    air.heat();
    for (auto _ : state) {
        air.step(1.0F / 30.0F, 3.0F);
    }
}

/// The default look in air, with two octaves of turbulence below the grid. A short loop, whose air is baked once for
/// all numbers of particles.
/// @param deformation of each particle, 0: they stay balls
Effect inAir(int particles, float deformation)
{
    Effect effect;
    effect.look.deformation = deformation;
    effect.emitter.count = particles;
    effect.turbulence.octaves = 2;
    effect.air.enabled = true;
    effect.timeline.loop = true;
    effect.timeline.length = 24;
    return effect;
}

/// A step of particles through air that is baked.
void carry(benchmark::State& state, AirCache& shelf, const Effect& of, int threads, const std::string& simd)
{
    const SampledEffect effect = sampled(of);
    const std::shared_ptr<BakedAir> air = shelf.airOf(effect);
    if (!air->bake(0)) {
        state.SkipWithError("the air was not baked");
        return;
    }
    const ThreadLimit limit(threads);
    if (!forceSimdTarget(simd)) {
        state.SkipWithError("not on this machine");
        return;
    }
    const SimulationModel model(effect, air);
    Particles carried;
    std::int64_t at = model.schedule().firstStep + model.schedule().lifetimeSteps;
    (void)advanceFromNothing(model, carried, at);
    for (auto _ : state) {
        (void)advance(model, carried, at, at + 1);
        ++at;
    }
    (void)forceSimdTarget("");
}

void obviousCarry(benchmark::State& state, int count)
{
    const glm::ivec3 cells{32, 64, 32};
    ObviousAir air(cells.x, cells.y, cells.z, kHeight / static_cast<float>(cells.y));
    air.heat();
    for (int i = 0; i < 30; ++i) {
        air.step(1.0F / 30.0F, 3.0F);
    }
    std::vector<ObviousAir::Place> particles;
    for (int i = 0; i < count; ++i) {
        particles.push_back({static_cast<float>(i % cells.x), static_cast<float>(i / 7 % cells.y),
            static_cast<float>(i / 11 % cells.z)});
    }
    for (auto _ : state) {
        air.carry(particles, 1.0F / 30.0F);
    }
}

void addCarried(std::vector<Claim>& claims)
{
    const auto add = [](const std::string& name, const auto& run) {
        benchmark::RegisterBenchmark(name.c_str(), run)->UseRealTime()->Unit(benchmark::kMillisecond);
    };
    const auto shelf = std::make_shared<AirCache>();
    struct Number {
        int particles;
        std::string text;
        double target; ///< ms on two threads
    };
    for (const Number& number : {Number{100000, "100 000", 1.0}, Number{1000000, "1 000 000", 10.0}}) {
        const int count = number.particles;
        const Effect balls = inAir(count, 0.0F);
        const Effect ellipsoids = inAir(count, 1.0F);
        const std::string name = "carried/" + std::to_string(count);
        add(name, [=](benchmark::State& state) { carry(state, *shelf, balls, 2, ""); });
        add(name + "_1thread", [=](benchmark::State& state) { carry(state, *shelf, balls, 1, ""); });
        add(name + "_ellipsoids", [=](benchmark::State& state) { carry(state, *shelf, ellipsoids, 2, ""); });
        add(name + "_obvious", [=](benchmark::State& state) { obviousCarry(state, count); });
        claims.push_back(
            {number.text + " particles through air, 2 octaves, a step, 2 threads", name, "", "", number.target, true});
        claims.push_back({"  2 threads over 1", name, name + "_1thread", "", 1.7});
        claims.push_back({"  when they deform, too", name + "_ellipsoids", "", ""});
        claims.push_back(
            {"  1 thread over the obvious program without noise", name + "_1thread", name + "_obvious", ""});
        for (const std::string& simd : availableSimdTargets()) {
            add(name + "_" + simd, [=](benchmark::State& state) { carry(state, *shelf, balls, 2, simd); });
            claims.push_back({"  on " + simd, name + "_" + simd, "", ""});
        }
    }
}

} // namespace

void addAirBenchmarks(std::vector<Claim>& claims)
{
    const auto add = [](const std::string& name, const auto& run) {
        benchmark::RegisterBenchmark(name.c_str(), run)->UseRealTime()->Unit(benchmark::kMillisecond);
    };
    struct Size {
        glm::ivec3 cells;
        double target; ///< ms on two threads
    };
    for (const Size& size : {Size{{32, 64, 32}, 1.5}, Size{{48, 96, 48}, 5.0}, Size{{64, 128, 64}, 13.0}}) {
        const glm::ivec3 cells = size.cells;
        const std::string text =
            std::to_string(cells.x) + "x" + std::to_string(cells.y) + "x" + std::to_string(cells.z);
        const std::string name = "air/" + text;
        add(name, [=](benchmark::State& state) { airStep(state, cells, 2, ""); });
        add(name + "_1thread", [=](benchmark::State& state) { airStep(state, cells, 1, ""); });
        add(name + "_obvious", [=](benchmark::State& state) { obviousAir(state, cells); });
        claims.push_back({"air, " + text + ", a step, 2 threads", name, "", "", size.target, true});
        claims.push_back({"  2 threads over 1", name, name + "_1thread", "", 1.7});
        claims.push_back({"  1 thread over the obvious program", name + "_1thread", name + "_obvious", ""});
        for (const std::string& simd : availableSimdTargets()) {
            add(name + "_" + simd, [=](benchmark::State& state) { airStep(state, cells, 2, simd); });
            claims.push_back({"  on " + simd, name + "_" + simd, "", ""});
        }
    }
    for (const int cells : {48, 64, 96}) {
        const std::string text = std::to_string(cells);
        const std::string name = "air/ball_" + text;
        add(name + "_stands", [=](benchmark::State& state) { airAroundBall(state, cells, false); });
        add(name + "_moves", [=](benchmark::State& state) { airAroundBall(state, cells, true); });
        claims.push_back({"air, " + text + " cells, a ball that moves over one that stands, time of the step",
            name + "_stands", name + "_moves", "", 1.1, true});
    }
    addCarried(claims);
}

} // namespace fumage::benchmarks
