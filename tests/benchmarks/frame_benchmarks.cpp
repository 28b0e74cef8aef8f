#include "tests/benchmarks/measure.h"

#include "core/base/parallel.h"
#include "core/preset/library.h"
#include "core/rendering/renderer.h"
#include "core/rendering/scene_renderer.h"
#include "core/rendering/view_transform.h"
#include "core/simulation/scene_simulator.h"

#include <cmath>

namespace fumage::benchmarks {

namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;

/// Step, light, sort and composite of frame after frame, as the viewport plays them once its air is baked.
void play(benchmark::State& state, const Scene& scene, int width, int height, int threads)
{
    const ThreadLimit limit(threads);
    const std::vector<SampledEffect> layers = sampledLayers(scene);
    SceneSimulator simulator(layers, 0);
    Renderer renderer;
    renderer.setPhaseMix(PhaseMix::Choose);
    Image image;
    int number = 0;
    RenderTimes sums;
    std::chrono::nanoseconds stepping{0};
    // The first frames make room for themselves; playing goes on in buffers that are there.
    constexpr int kWarmUp = 6;
    constexpr int kBaked = 200; // more than are played
    if (scene.air.enabled) {
        (void)simulator.frame(kBaked);
    }
    for (; number < kWarmUp; ++number) {
        const SceneFrame frame = simulator.frame(number).value();
        (void)renderer.render(LayersAtFrame(frame, layers), width, height, image);
    }
    for (auto _ : state) {
        const auto start = std::chrono::steady_clock::now();
        const SceneFrame frame = simulator.frame(number++).value();
        stepping += std::chrono::steady_clock::now() - start;
        (void)renderer.render(LayersAtFrame(frame, layers), width, height, image);
        sums.light += renderer.times().light;
        sums.sprites += renderer.times().sprites;
        sums.composite += renderer.times().composite;
    }
    const auto mean = [&](std::chrono::nanoseconds sum) {
        return benchmark::Counter(static_cast<double>(sum.count()) * 1e-6, benchmark::Counter::kAvgIterations);
    };
    state.counters["step_ms"] = mean(stepping);
    state.counters["light_ms"] = mean(sums.light);
    state.counters["sprites_ms"] = mean(sums.sprites);
    state.counters["composite_ms"] = mean(sums.composite);
    state.counters["frames/s"] =
        benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

/// The default look with another number of particles, whose area is divided so that together they cover as much.
Effect defaultLook(int count)
{
    Effect effect = newPreset().scene.effect();
    effect.look.size *= std::sqrt(static_cast<float>(effect.emitter.count) / static_cast<float>(count));
    effect.emitter.count = count;
    return effect;
}

/// A scene whose particles are divided among layers that are alike but for their seeds. The first one feeds the air:
/// the smoke is as large as that of one layer with all particles.
Scene inLayers(Scene scene, int layers)
{
    scene.layers.resize(static_cast<std::size_t>(layers), scene.layers.front());
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        scene.layers[i].emitter.count /= layers;
        scene.layers[i].emitter.seed += static_cast<std::uint32_t>(i);
        scene.layers[i].source.feeds = scene.layers[i].source.feeds && i == 0;
    }
    return scene;
}

void encodeForScreen(benchmark::State& state)
{
    Image image;
    image.resize(kWidth, kHeight);
    std::fill(image.pixels.begin(), image.pixels.end(), 0.5F);
    EncodedImage<std::uint8_t> encoded;
    for (auto _ : state) {
        encode(image, Output{}, encoded);
    }
}

} // namespace

void addFrameBenchmarks(std::vector<Claim>& claims)
{
    const auto add = [](const std::string& name, const Scene& scene, int width, int height, int threads) {
        benchmark::RegisterBenchmark(
            name.c_str(), [=](benchmark::State& state) { play(state, scene, width, height, threads); })
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
    };
    add("frame/default", newPreset().scene.effect(), kWidth, kHeight, 2);
    add("frame/default_100k", defaultLook(100000), kWidth, kHeight, 2);
    add("frame/default_1M", defaultLook(1000000), kWidth, kHeight, 2);
    add("frame/default_100k_1thread", defaultLook(100000), kWidth, kHeight, 1);
    add("frame/default_512", newPreset().scene.effect(), 512, 512, 2);
    Effect finest = newPreset().scene.effect();
    finest.output.quality = Quality::Final;
    add("frame/default_4k_final", finest, 3840, 2160, 2);
    benchmark::RegisterBenchmark("frame/encode_8bit", encodeForScreen)->UseRealTime()->Unit(benchmark::kMillisecond);
    const auto addParts = [&](const std::string& name) {
        for (const char* part : {"step_ms", "light_ms", "sprites_ms", "composite_ms"}) {
            claims.push_back({"  part", name, "", part});
        }
    };
    claims.push_back({"whole frame, default preset, 1280 x 720, 2 threads", "frame/default", "", "frames/s", 60.0});
    addParts("frame/default");
    claims.push_back({"whole frame, 100 000 particles", "frame/default_100k", "", "frames/s"});
    addParts("frame/default_100k");
    claims.push_back({"  2 threads over 1", "frame/default_100k", "frame/default_100k_1thread", "", 1.8});
    claims.push_back({"whole frame, 1 000 000 particles", "frame/default_1M", "", "frames/s", 15.0});
    addParts("frame/default_1M");
    for (const auto& [layers, most] : {std::pair{4, 1.15}, std::pair{16, 1.3}}) {
        const std::string name = "frame/layers_" + std::to_string(layers);
        add(name, inLayers(defaultLook(100000), layers), kWidth, kHeight, 2);
        claims.push_back({"100 000 particles in " + std::to_string(layers) + " layers over one", "frame/default_100k",
            name, "", most, true});
        addParts(name);
    }
    claims.push_back({"default preset at 512 x 512", "frame/default_512", "", "", 16.0, true});
    claims.push_back(
        {"default preset in final quality at 3840 x 2160", "frame/default_4k_final", "", "", 2000.0, true});
    claims.push_back({"encoding 1280 x 720 for the screen", "frame/encode_8bit", "", ""});

    struct Row {
        int particles;
        double thesis;
    };
    const Result<PresetReading> thesis = loadPreset(std::string("thesis-2012"));
    if (!thesis) {
        return;
    }
    for (const Row& row :
        {Row{1000, 114.67}, Row{2500, 48.00}, Row{5000, 24.89}, Row{10000, 13.33}, Row{20000, 6.40}}) {
        Effect effect = thesis.value().preset.scene.effect();
        effect.emitter.count = row.particles;
        const std::string name = "frame/thesis_" + std::to_string(row.particles);
        add(name, effect, kWidth, kHeight, 2);
        claims.push_back({"2012 preset, " + std::to_string(row.particles)
                + " particles (2012: " + std::to_string(row.thesis).substr(0, 6) + ")",
            name, "", "frames/s", row.thesis});
    }
}

} // namespace fumage::benchmarks
