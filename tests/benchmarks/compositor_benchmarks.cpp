#include "tests/benchmarks/measure.h"

#include "core/base/hash.h"
#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/base/simd.h"
#include "core/rendering/compositor.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace fumage::benchmarks {

namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;

const SpriteTexture& texture()
{
    static const SpriteTexture baked = [] {
        Noise noise;
        noise.slices = 32;
        return SpriteTexture::bake(noise).value();
    }();
    return baked;
}

/// Rotated sprites of one size, spread evenly over the picture, with low alpha so that many targets show.
SpriteBatch scatteredSprites(int count, float edge, float opacity, bool shaded = false)
{
    SpriteBatch batch;
    batch.view.width = kWidth;
    batch.view.height = kHeight;
    batch.style.hardness = 1.0F;
    batch.style.texture = 0.8F;
    batch.style.relief = shaded ? 0.5F : 0.0F;
    batch.style.lightX = 0.7F;
    const float radius = 0.5F * edge;
    for (int i = 0; i < count; ++i) {
        const std::uint32_t key = keyOf(1, static_cast<std::uint64_t>(i));
        const float angle = kPi * signedFloat(streamBits(key, 0));
        Sprite s;
        s.x = unitFloat(streamBits(key, 1)) * kWidth;
        s.y = unitFloat(streamBits(key, 2)) * kHeight;
        s.halfWidth = s.halfHeight = radius;
        s.m00 = s.m11 = portableCos(angle) / radius;
        s.m01 = portableSin(angle) / radius;
        s.m10 = -s.m01;
        s.direct[0] = s.direct[1] = s.direct[2] = 0.7F;
        s.ambient[0] = s.ambient[1] = s.ambient[2] = 0.2F;
        s.opacity = opacity;
        const int level = std::clamp(static_cast<int>(std::log2(64.0F / edge)), 0, texture().levels() - 1);
        s.texture = edge < 6.0F
            ? packTexture(0, TextureRef::kPlain, 0, 0, 0)
            : packTexture(key >> 27U, static_cast<std::uint32_t>(level), key & 255U, key >> 8U & 255U, 6);
        batch.add(s, streamBits(key, 3) >> 10U);
    }
    return batch;
}

/// Gives sprites detail that the air carries: neighbours read the same noise, a texel a pixel.
/// @param phases 1 or 2
void addDetail(SpriteBatch& batch, int phases)
{
    constexpr std::uint8_t kLevel = DetailTexture::kLevels - 1;
    const auto size = static_cast<float>(DetailTexture::size(kLevel));
    for (const Sprite& sprite : batch.sprites) {
        SpriteDetail detail;
        for (SpriteDetail::Phase& phase : detail.phases) {
            phase.at = {std::fmod(sprite.x, size), std::fmod(sprite.y, size), std::fmod(sprite.x + sprite.y, size)};
            phase.u = {0.8F, 0.1F, 0.4F};
            phase.v = {0.2F, 0.7F, -0.3F};
            phase.light = LightBytes(0.5F, 0.3F, 0.2F).packed;
            phase.relief = 0.01F;
            phase.weight = 0.7F;
        }
        detail.strength = 1.0F;
        detail.levels = {kLevel, kLevel};
        detail.shown = {1, static_cast<std::uint8_t>(phases - 1)};
        batch.details.push_back(detail);
    }
}

void compose(
    benchmark::State& state, int count, float edge, int threads, const std::string& simd, bool shaded, int phases)
{
    const ThreadLimit limit(threads);
    if (!forceSimdTarget(simd)) {
        state.SkipWithError("not on this machine");
        return;
    }
    SpriteBatch batch = scatteredSprites(count, edge, 0.1F, shaded);
    if (phases > 0) {
        addDetail(batch, phases);
    }
    Compositor compositor;
    Image image;
    for (auto _ : state) {
        const SpriteLayer layer{&batch, &texture()};
        (void)compositor.compose({&layer, 1}, image);
    }
    state.counters["frames/s"] =
        benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
    state.counters["Mpixels/s"] = benchmark::Counter(
        static_cast<double>(count) * static_cast<double>(edge * edge) * 1e-6 * static_cast<double>(state.iterations()),
        benchmark::Counter::kIsRate);
    (void)forceSimdTarget("");
}

/// The same blending as anyone would write it first: sorted, sprite after sprite, pixel after pixel, far to near.
void obvious(benchmark::State& state, int count, float edge)
{
    const SpriteBatch batch = scatteredSprites(count, edge, 0.1F);
    std::vector<std::size_t> order(batch.sprites.size());
    std::vector<float> image(static_cast<std::size_t>(kWidth) * kHeight * 4);
    const int size = texture().size();
    for (auto _ : state) {
        for (std::size_t i = 0; i < order.size(); ++i) {
            order[i] = i;
        }
        std::sort(
            order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return batch.depth[a] > batch.depth[b]; });
        std::fill(image.begin(), image.end(), 0.0F);
        for (const std::size_t index : order) {
            const Sprite& s = batch.sprites[index];
            const std::uint32_t* texels = texture().texels(0, 0);
            for (int y = std::max(0, static_cast<int>(s.y - s.halfHeight));
                 y < std::min(kHeight, static_cast<int>(s.y + s.halfHeight) + 1); ++y) {
                for (int x = std::max(0, static_cast<int>(s.x - s.halfWidth));
                     x < std::min(kWidth, static_cast<int>(s.x + s.halfWidth) + 1); ++x) {
                    const float dx = static_cast<float>(x) + 0.5F - s.x;
                    const float dy = static_cast<float>(y) + 0.5F - s.y;
                    const float p = s.m00 * dx + s.m01 * dy;
                    const float q = s.m10 * dx + s.m11 * dy;
                    const float inside = 1.0F - p * p - q * q;
                    if (inside <= 0.0F) {
                        continue;
                    }
                    const float u = (p + 1.0F) * 0.5F * static_cast<float>(size - 1);
                    const float v = (q + 1.0F) * 0.5F * static_cast<float>(size - 1);
                    const std::uint32_t t = texels[static_cast<int>(v) * size + static_cast<int>(u)];
                    const float fu = u - std::floor(u);
                    const float fv = v - std::floor(v);
                    const auto byte = [&](unsigned shift) { return static_cast<float>(t >> shift & 255U); };
                    const float low = byte(0) + fu * (byte(8) - byte(0));
                    const float high = byte(16) + fu * (byte(24) - byte(16));
                    const float a = s.opacity * inside * inside * (low + fv * (high - low)) / 255.0F;
                    float* pixel =
                        image.data() + (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)) * 4;
                    for (int channel = 0; channel < 3; ++channel) {
                        pixel[channel] = pixel[channel] * (1.0F - a) + a * (s.direct[channel] + s.ambient[channel]);
                    }
                    pixel[3] = pixel[3] * (1.0F - a) + a;
                }
            }
        }
        benchmark::DoNotOptimize(image.data());
    }
}

} // namespace

void addCompositorBenchmarks(std::vector<Claim>& claims)
{
    struct Case {
        int count;
        float edge;
        double framesPerSecond;
        const char* llvmpipe;
    };
    for (const Case& each :
        {Case{20000, 64.0F, 30.0, "3.6"}, Case{20000, 16.0F, 250.0, "36"}, Case{1000000, 4.0F, 20.0, "1.9"}}) {
        const std::string name =
            "compositor/" + std::to_string(each.count) + "x" + std::to_string(static_cast<int>(each.edge)) + "px";
        const auto add = [&](const std::string& suffix, int threads, const std::string& simd, bool shaded = false,
                             int phases = 0) {
            benchmark::RegisterBenchmark((name + suffix).c_str(),
                [=](benchmark::State& state) { compose(state, each.count, each.edge, threads, simd, shaded, phases); })
                ->UseRealTime()
                ->Unit(benchmark::kMillisecond);
        };
        add("", 2, "");
        add("_1thread", 1, "");
        add("_shaded", 2, "", true);
        add("_detail", 2, "", false, 2);
        add("_detail_1phase", 2, "", false, 1);
        benchmark::RegisterBenchmark(
            (name + "_obvious").c_str(), [=](benchmark::State& state) { obvious(state, each.count, each.edge); })
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
        claims.push_back({name + ", 1280 x 720, 2 threads (llvmpipe: " + each.llvmpipe + ")", name, "", "frames/s",
            each.framesPerSecond});
        claims.push_back({"  shaded by the slope of the noise", name + "_shaded", "", "frames/s"});
        claims.push_back({"  in detail that the air carries, both phases", name + "_detail", "", "frames/s"});
        claims.push_back({"  one phase", name + "_detail_1phase", "", "frames/s"});
        claims.push_back({"  over the obvious scalar program, 1 thread", name, name + "_obvious", ""});
        claims.push_back({"  2 threads over 1", name, name + "_1thread", "", 1.8});
        for (const std::string& simd : availableSimdTargets()) {
            add("_" + simd, 2, simd);
            claims.push_back({"  on " + simd, name + "_" + simd, "", "frames/s"});
        }
    }
}

} // namespace fumage::benchmarks
