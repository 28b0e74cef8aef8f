#include "tests/benchmarks/measure.h"
#include "tests/benchmarks/obvious.h"
#include "tests/effects.h"

#include "core/base/parallel.h"
#include "core/base/simd.h"
#include "core/simulation/advance.h"

namespace fumage::benchmarks {

namespace {

constexpr int kThesisParticles = 20000;

/// The 2012 model's motion with all its randomness, and nothing else.
Effect thesisMotion()
{
    Effect effect = tests::thesisEffect(kThesisParticles);
    effect.emitter.velocityRandomness = 1.0F;
    effect.wind.strength = 0.5F;
    effect.wind.angle = 37.0F;
    effect.motion.gravity = 0.5F;
    effect.motion.randomness = 1.0F;
    return effect;
}

Effect wholeModel(int particles, int octaves)
{
    Effect effect;
    effect.emitter.count = particles;
    effect.turbulence.octaves = octaves;
    return effect;
}

void countRate(benchmark::State& state, std::int64_t particles, std::int64_t steps)
{
    state.counters["Mparticles/s"] =
        benchmark::Counter(static_cast<double>(particles * steps) * 1e-6 * static_cast<double>(state.iterations()),
            benchmark::Counter::kIsRate);
}

void obvious(benchmark::State& state, std::unique_ptr<Obvious2012> program)
{
    for (auto _ : state) {
        program->step();
    }
    countRate(state, kThesisParticles, 1);
}

/// @param stepsAtOnce steps of one call: 1 is what playing does, more is what seeking does
void step(benchmark::State& state, const Effect& effect, int threads, const std::string& simd, int stepsAtOnce)
{
    const ThreadLimit limit(threads);
    if (!forceSimdTarget(simd)) {
        state.SkipWithError("not on this machine");
        return;
    }
    const SimulationModel model(sampled(effect));
    Particles particles;
    std::int64_t at = model.schedule().lifetimeSteps;
    (void)advanceFromNothing(model, particles, at);
    for (auto _ : state) {
        (void)advance(model, particles, at, at + stepsAtOnce);
        at += stepsAtOnce;
    }
    countRate(state, static_cast<std::int64_t>(particles.capacity), stepsAtOnce);
    (void)forceSimdTarget("");
}

} // namespace

void addStepBenchmarks(std::vector<Claim>& claims)
{
    const auto add = [](const std::string& name, const Effect& effect, int threads, const std::string& simd = "",
                         int stepsAtOnce = 1) {
        benchmark::RegisterBenchmark(
            name.c_str(), [=](benchmark::State& state) { step(state, effect, threads, simd, stepsAtOnce); })
            ->UseRealTime()
            ->Unit(benchmark::kMicrosecond);
    };
    benchmark::RegisterBenchmark(
        "step2012/obvious", [](benchmark::State& state) { obvious(state, makeObvious2012(kThesisParticles)); })
        ->UseRealTime()
        ->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark("step2012/obvious_native",
        [](benchmark::State& state) { obvious(state, makeObvious2012Native(kThesisParticles)); })
        ->UseRealTime()
        ->Unit(benchmark::kMicrosecond);
    add("step2012/fumage", thesisMotion(), 1);
    for (const std::string& simd : availableSimdTargets()) {
        add("step2012/fumage_" + simd, thesisMotion(), 1, simd);
    }
    add("step2012/fumage_16_steps", thesisMotion(), 1, "", 16);
    claims.push_back({"2012 kernel, 20 000 particles, 1 thread, over the obvious program", "step2012/fumage",
        "step2012/obvious", "", 30.0});
    claims.push_back(
        {"  over the same built with -march=native", "step2012/fumage", "step2012/obvious_native", "", 10.0});
    claims.push_back({"  rate", "step2012/fumage", "", "Mparticles/s"});
    for (const std::string& simd : availableSimdTargets()) {
        claims.push_back({"  rate on " + simd, "step2012/fumage_" + simd, "", "Mparticles/s"});
    }
    claims.push_back(
        {"  rate when 16 steps are taken at once, as in seeking", "step2012/fumage_16_steps", "", "Mparticles/s"});

    constexpr int kMillion = 1000000;
    for (const int octaves : {2, 4}) {
        const std::string name = "stepWhole/1M_octaves" + std::to_string(octaves);
        const std::string what = "whole model, 1 000 000 particles, " + std::to_string(octaves) + " octaves, 2 threads";
        add(name, wholeModel(kMillion, octaves), 2);
        claims.push_back({what, name, "", "", octaves == 2 ? 10.0 : 20.0, true});
        for (const std::string& simd : availableSimdTargets()) {
            add(name + "_" + simd, wholeModel(kMillion, octaves), 2, simd);
            claims.push_back({"  on " + simd, name + "_" + simd, "", ""});
        }
    }
    add("stepWhole/1M_octaves4_1thread", wholeModel(kMillion, 4), 1);
    claims.push_back({"  2 threads over 1", "stepWhole/1M_octaves4", "stepWhole/1M_octaves4_1thread", "", 1.8});
    for (const int count : {10000, 100000, kMillion}) {
        const std::string name = "stepWhole/count" + std::to_string(count);
        add(name, wholeModel(count, 4), 1);
        claims.push_back({"  " + std::to_string(count) + " particles, 1 thread", name, "", "Mparticles/s"});
    }
}

} // namespace fumage::benchmarks
