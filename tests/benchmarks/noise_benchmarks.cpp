#include "tests/benchmarks/measure.h"
#include "tests/noise/obvious_simplex.h"

#include "core/base/parallel.h"
#include "core/base/simd.h"
#include "core/noise/fractal.h"
#include "core/noise/texture.h"

#include <memory>

namespace fumage::benchmarks {

namespace {

constexpr int kSize = 512;
constexpr float kBetweenPlanes = 0.37F;

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
    state.counters["Mpixels/s"] =
        benchmark::Counter(static_cast<double>(kSize * kSize) * 1e-6 * static_cast<double>(state.iterations()),
            benchmark::Counter::kIsRate);
}

/// A tile has the size at which the heap gives memory back to the system, or not, by the chance of what lies above it;
/// to get it again costs as much as the noise. Something kept above holds it.
std::unique_ptr<char[]> heldHeap(const Noise& noise)
{
    constexpr std::size_t kBytes = 4096;
    const auto first = bakeFractal(noise, kSize, 0.0F); // the first large block never comes from the heap
    const auto second = bakeFractal(noise, kSize, 0.0F);
    return std::make_unique<char[]>(kBytes);
}

void bake(benchmark::State& state, const Noise& noise, float depth, const std::string& simd)
{
    const ThreadLimit limit(1);
    if (!forceSimdTarget(simd)) {
        state.SkipWithError("not on this machine");
        return;
    }
    const auto held = heldHeap(noise);
    for (auto _ : state) {
        benchmark::DoNotOptimize(bakeFractal(noise, kSize, depth));
    }
    countPixels(state);
    (void)forceSimdTarget("");
}

/// Octave after octave at one pixel after the other, without a thought of what they share.
/// @param noiseAt (octave, x, y, z) in lattice units
template <class NoiseAt>
void bakeObviously(benchmark::State& state, const Noise& noise, const NoiseAt& noiseAt)
{
    const std::vector<Octave> octaves = fractalOctaves(noise, kSize);
    std::vector<float> pixels(static_cast<std::size_t>(kSize) * kSize);
    for (auto _ : state) {
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                float sum = 0.0F;
                for (const Octave& octave : octaves) {
                    const float scale = static_cast<float>(octave.period.x) / kSize;
                    sum += octave.amplitude
                        * noiseAt(octave, (static_cast<float>(x) + 0.5F) * scale,
                            (static_cast<float>(y) + 0.5F) * scale,
                            kBetweenPlanes * static_cast<float>(octave.period.z));
                }
                pixels[static_cast<std::size_t>(y * kSize + x)] = sum;
            }
        }
        benchmark::DoNotOptimize(pixels.data());
    }
    countPixels(state);
}

void obviousLattice(benchmark::State& state)
{
    const Noise noise = sixOctaves(NoiseBasis::Lattice);
    bakeObviously(state, noise, [&](const Octave& octave, float x, float y, float z) {
        return valueNoise(noise, octave.seed, octave.period, x, y, z);
    });
}

void obviousSimplex(benchmark::State& state)
{
    bakeObviously(state, sixOctaves(NoiseBasis::Simplex), tests::obviousSimplex<float>);
}

} // namespace

void addNoiseBenchmarks(std::vector<Claim>& claims)
{
    const auto add = [](const std::string& name, const Noise& noise, float depth, const std::string& simd = "") {
        benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { bake(state, noise, depth, simd); })
            ->UseRealTime()
            ->Unit(benchmark::kMicrosecond);
    };
    benchmark::RegisterBenchmark("noise/obvious_lattice3d", obviousLattice)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("noise/obvious_simplex3d", obviousSimplex)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
    const Noise gradient = sixOctaves(NoiseBasis::Gradient);
    add("noise/gradient2d", gradient, 0.0F);
    add("noise/gradient3d", gradient, kBetweenPlanes);
    const Noise lattice = sixOctaves(NoiseBasis::Lattice);
    add("noise/lattice3d", lattice, kBetweenPlanes);
    Noise smoothCubic = lattice;
    smoothCubic.interpolation = Interpolation::Cubic;
    smoothCubic.smooth = 1.0F;
    add("noise/lattice3d_smooth_cubic", smoothCubic, kBetweenPlanes);
    add("noise/simplex3d", sixOctaves(NoiseBasis::Simplex), kBetweenPlanes);
    claims.push_back({"gradient noise, 512 x 512, 6 octaves, 1 thread (FastNoise2: 256)", "noise/gradient2d", "",
        "Mpixels/s", 600.0});
    claims.push_back({"  slice of 3D (FastNoise2: 160)", "noise/gradient3d", "", "Mpixels/s", 300.0});
    for (const std::string& simd : availableSimdTargets()) {
        add("noise/gradient3d_" + simd, gradient, kBetweenPlanes, simd);
        claims.push_back({"  slice of 3D on " + simd, "noise/gradient3d_" + simd, "", "Mpixels/s"});
    }
    claims.push_back({"lattice value noise, slice of 3D (FastNoise2: 218)", "noise/lattice3d", "", "Mpixels/s", 450.0});
    claims.push_back({"  over the same, pixel by pixel", "noise/lattice3d", "noise/obvious_lattice3d", ""});
    claims.push_back({"  cubic and smooth", "noise/lattice3d_smooth_cubic", "", "Mpixels/s"});
    claims.push_back({"simplex noise, slice of 3D (FastNoise2: 136)", "noise/simplex3d", "", "Mpixels/s", 280.0});
    claims.push_back({"  over the same, pixel by pixel", "noise/simplex3d", "noise/obvious_simplex3d", ""});
}

} // namespace fumage::benchmarks
