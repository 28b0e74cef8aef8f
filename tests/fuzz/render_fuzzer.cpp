// Smoke with every parameter anywhere in its range, mostly at the ends, in pictures of a few pixels: no fault, and
// every number finite.

#include "tests/fuzz/expect.h"

#include "core/effect/parameter_table.h"
#include "core/effect/sampling.h"
#include "core/effect/value.h"
#include "core/export/data/particle_dump.h"
#include "core/image_io/png_file.h"
#include "core/rendering/renderer.h"
#include "core/simulation/schedule.h"
#include "core/simulation/simulator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <fuzzer/FuzzedDataProvider.h>

namespace {

using namespace fumage;

/// An end of the hard range, an end of the soft one, or something between.
float numberFrom(FuzzedDataProvider& bytes, const Parameter& parameter)
{
    const std::array<double, 4> ends{parameter.hard.low, parameter.hard.high, parameter.soft.low, parameter.soft.high};
    const auto choice = bytes.ConsumeIntegralInRange<std::size_t>(0, ends.size());
    return static_cast<float>(choice < ends.size()
            ? ends[choice]
            : parameter.hard.low + bytes.ConsumeProbability<double>() * (parameter.hard.high - parameter.hard.low));
}

/// None, or one of a few pixels of any colour.
Bitmap pictureFrom(FuzzedDataProvider& bytes)
{
    constexpr int kMaxEdge = 4;
    PngPixels png{.width = bytes.ConsumeIntegralInRange<int>(0, kMaxEdge),
        .height = bytes.ConsumeIntegralInRange<int>(1, kMaxEdge)};
    const auto pixels = bytes.ConsumeBytes<std::uint8_t>(static_cast<std::size_t>(4 * png.width * png.height));
    png.bytes = std::as_bytes(std::span(pixels));
    if (png.width == 0 || pixels.size() < static_cast<std::size_t>(4 * png.width * png.height)) {
        return {};
    }
    return Bitmap::read(encodePng(png).value()).value();
}

Value valueFrom(FuzzedDataProvider& bytes, const Parameter& parameter)
{
    switch (parameter.kind) {
    case Kind::Bool: return bytes.ConsumeBool();
    case Kind::Int: return static_cast<int>(numberFrom(bytes, parameter));
    case Kind::Float: return numberFrom(bytes, parameter);
    case Kind::Choice: return bytes.ConsumeIntegralInRange<int>(0, static_cast<int>(parameter.choices.size()) - 1);
    case Kind::Seed: return bytes.ConsumeIntegral<std::uint32_t>();
    case Kind::Direction: {
        const auto component = [&] { return static_cast<float>(bytes.ConsumeIntegralInRange<int>(-1, 1)); };
        return glm::vec3(component(), component(), component());
    }
    case Kind::Vector:
    case Kind::Colour:
        return glm::vec3(numberFrom(bytes, parameter), numberFrom(bytes, parameter), numberFrom(bytes, parameter));
    case Kind::Curve:
        return Curve{{0.0F, numberFrom(bytes, parameter)},
            {bytes.ConsumeProbability<float>(), numberFrom(bytes, parameter)}, {1.0F, numberFrom(bytes, parameter)}};
    case Kind::Gradient: {
        const auto colour = [&] {
            return glm::vec3(numberFrom(bytes, parameter), numberFrom(bytes, parameter), numberFrom(bytes, parameter));
        };
        return Gradient{{0.0F, colour()}, {bytes.ConsumeProbability<float>(), colour()}};
    }
    case Kind::Picture: return pictureFrom(bytes);
    }
    return 0;
}

/// Small enough that many are seen in a second; what is left out here is only more of the same.
void makeCheap(Effect& effect)
{
    constexpr int kFew = 8;
    constexpr std::int64_t kMaxSteps = 200;
    effect.emitter.count = std::min(effect.emitter.count, 4 * kFew);
    effect.noise.resolution = std::min(effect.noise.resolution, kFew);
    effect.noise.slices = std::min(effect.noise.slices, 2);
    effect.light.resolution = std::min(effect.light.resolution, kFew);
    effect.output.supersample = std::min(effect.output.supersample, 2);
    effect.output.quality = std::min(effect.output.quality, Quality::Good);
    effect.timeline.length = std::min(effect.timeline.length, kFew);
    effect.air.resolution = std::min(effect.air.resolution, kMinAirResolution);
    if (makeSchedule(sampled(effect)).firstStep < -kMaxSteps) {
        effect.timeline.prewarm = false;
        effect.timeline.loop = false;
    }
}

bool isFinite(const Image& image)
{
    return std::all_of(image.pixels.begin(), image.pixels.end(), [](float value) { return std::isfinite(value); });
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    FuzzedDataProvider bytes(data, size);
    const int width = bytes.ConsumeIntegralInRange<int>(1, 9);
    const int height = bytes.ConsumeIntegralInRange<int>(1, 9);
    const int number = bytes.ConsumeIntegralInRange<int>(0, 6);
    Effect effect;
    while (bytes.remaining_bytes() > 0) {
        const Parameter& parameter =
            parameterTable()[bytes.ConsumeIntegralInRange<std::size_t>(0, parameterTable().size() - 1)];
        setClamped(effect, parameter, valueFrom(bytes, parameter));
    }
    makeCheap(effect);
    const SampledEffect smoke = sampled(effect);
    Simulator simulator(smoke);
    const Result<std::shared_ptr<const Frame>> frame = simulator.frame(number);
    FUMAGE_EXPECT(frame);
    const std::string particles = dumpCsv(*frame.value(), smoke);
    FUMAGE_EXPECT(particles.find("nan") == std::string::npos && particles.find("inf") == std::string::npos);
    Renderer renderer;
    Image image;
    FUMAGE_EXPECT(renderer.render(*frame.value(), smoke, width, height, image));
    FUMAGE_EXPECT(isFinite(image));
    return 0;
}
