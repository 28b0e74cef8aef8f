#include "tests/benchmarks/measure.h"

#include "core/base/parallel.h"
#include "core/base/simd.h"
#include "core/noise/lattice_noise.h"
#include "core/noise/texture.h"

namespace fumage::benchmarks {

namespace {

constexpr int kSize = 512;

Noise sixOctaves(NoiseBasis basis)
{
    Noise noise;
    noise.basis = basis;
    noise.octaves = 6;
    noise.wavelength = 0.125F;
    noise.warp = 0.0F;
    return noise;
}

void countPixels(benchmark::State& state)
{
    state.counters["Mpixels/s"] = benchmark::Counter(static_cast<double>(kSize * kSize) * 1e-6 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void bake(benchmark::State& state, const Noise& noise, float depth, const std::string& simd)
{
    const ThreadLimit limit(1);
    if (!forceSimdTarget(simd)) {
        state.SkipWithError("not on this machine");
        return;
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(bakeFractal(noise, kSize, depth));
    }
    countPixels(state);
    (void)forceSimdTarget("");
}

/// Value noise pixel by pixel with the scalar functions, octave after octave: what the 2012 model describes.
void obviousValueNoise(benchmark::State& state)
{
    const Noise noise = sixOctaves(NoiseBasis::Lattice);
    std::vector<float> pixels(static_cast<std::size_t>(kSize) * kSize);
    for (auto _ : state) {
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                float sum = 0.0F;
                float amplitude = 1.0F;
                int cells = 8;
                for (int octave = 0; octave < noise.octaves; ++octave) {
                    const float scale = static_cast<float>(cells) / kSize;
                    sum += amplitude * valueNoise(noise, static_cast<std::uint32_t>(octave), {cells, cells, 1}, static_cast<float>(x) * scale, static_cast<float>(y) * scale, 0.0F);
                    amplitude *= noise.persistence;
                    cells *= 2;
                }
                pixels[static_cast<std::size_t>(y * kSize + x)] = sum;
            }
        }
        benchmark::DoNotOptimize(pixels.data());
    }
    countPixels(state);
}

} // namespace

void addNoiseBenchmarks(std::vector<Claim>& claims)
{
    const auto add = [](const std::string& name, const Noise& noise, float depth, const std::string& simd = "") {
        benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { bake(state, noise, depth, simd); })->UseRealTime()->Unit(benchmark::kMicrosecond);
    };
    benchmark::RegisterBenchmark("noise/obvious", obviousValueNoise)->UseRealTime()->Unit(benchmark::kMillisecond);
    const Noise gradient = sixOctaves(NoiseBasis::Gradient);
    constexpr float kBetweenLayers = 0.37F;
    add("noise/gradient2d", gradient, 0.0F);
    add("noise/gradient3d", gradient, kBetweenLayers);
    add("noise/lattice3d", sixOctaves(NoiseBasis::Lattice), kBetweenLayers);
    add("noise/simplex3d", sixOctaves(NoiseBasis::Simplex), kBetweenLayers);
    claims.push_back({"gradient noise, 512 x 512, 6 octaves, 1 thread (FastNoise2: 256)", "noise/gradient2d", "", "Mpixels/s", 600.0});
    claims.push_back({"  slice of 3D (FastNoise2: 160)", "noise/gradient3d", "", "Mpixels/s", 300.0});
    for (const std::string& simd : availableSimdTargets()) {
        add("noise/gradient3d_" + simd, gradient, kBetweenLayers, simd);
        claims.push_back({"  slice of 3D on " + simd, "noise/gradient3d_" + simd, "", "Mpixels/s"});
    }
    claims.push_back({"  over scalar value noise, pixel by pixel", "noise/gradient2d", "noise/obvious", ""});
    claims.push_back({"lattice value noise, slice of 3D", "noise/lattice3d", "", "Mpixels/s"});
    claims.push_back({"simplex noise, slice of 3D", "noise/simplex3d", "", "Mpixels/s"});
}

} // namespace fumage::benchmarks
