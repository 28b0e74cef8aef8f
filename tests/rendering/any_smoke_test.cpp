// Whatever the numbers of a document are within their ranges, it becomes a picture or a sentence: nothing throws, and
// no pixel is no number.
#include "tests/helpers.h"

#include "core/base/hash.h"
#include "core/effect/parameter_table.h"
#include "core/effect/value.h"
#include "core/effect/variation.h"
#include "core/preset/library.h"

#include <algorithm>
#include <cmath>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kEdge = 16;
constexpr int kCells = 16; ///< of the air
constexpr int kParticles = 400;
constexpr float kMaxSteps = 40.0F; ///< of a life

/// FUMAGE_SMOKES=10000 tries as many of each kind; without it a number that takes seconds.
int smokesOfAKind()
{
    constexpr int kFew = 80;
    bool isSet = false;
    const int asked = qEnvironmentVariableIntValue("FUMAGE_SMOKES", &isSet);
    return isSet ? asked : kFew;
}

float unit(std::uint32_t seed, std::uint32_t draw)
{
    return unitFloat(streamBits(keyOf(seed, 77), draw));
}

/// Anywhere in a range: at an end of it, evenly, or by its magnitude.
double anywhere(const Range& range, float how, float where)
{
    const double low = range.low;
    const double high = range.high;
    if (how < 0.1F) {
        return where < 0.5F ? low : high;
    }
    if (how < 0.4F) {
        return low + (high - low) * static_cast<double>(where);
    }
    const double magnitude = std::pow(10.0, -4.0 + 4.0 * static_cast<double>(std::abs(2.0F * where - 1.0F)));
    return std::clamp(where < 0.5F && low < 0.0 ? low * magnitude : high * magnitude, low, high);
}

Value anyValue(const Parameter& parameter, const Value& now, std::uint32_t seed, std::uint32_t row)
{
    std::uint32_t draw = 16 * row;
    const auto next = [&] { return unit(seed, draw++); };
    const auto number = [&] {
        const float how = next();
        return anywhere(parameter.hard, how, next());
    };
    if (std::holds_alternative<bool>(now)) {
        return next() < 0.5F;
    }
    if (std::holds_alternative<int>(now)) {
        const double choices = static_cast<double>(parameter.choices.size());
        return static_cast<int>(
            parameter.kind == Kind::Choice ? std::floor(choices * static_cast<double>(next())) : std::round(number()));
    }
    if (std::holds_alternative<float>(now)) {
        return static_cast<float>(number());
    }
    if (std::holds_alternative<glm::vec3>(now)) {
        const auto x = static_cast<float>(number());
        const auto y = static_cast<float>(number());
        return glm::vec3(x, y, static_cast<float>(number()));
    }
    return std::holds_alternative<std::uint32_t>(now) ? Value(streamBits(seed, row)) : now;
}

/// A document in which each parameter is anything with a probability that differs from document to document.
Effect anyDocument(std::uint32_t seed)
{
    Effect effect;
    const float share = 0.05F + 0.6F * unit(seed, 0);
    std::uint32_t row = 1;
    for (const Parameter& parameter : parameterTable()) {
        if (unit(seed, 16 * row + 15) < share) {
            setClamped(effect, parameter, anyValue(parameter, parameter.get(effect), seed, row));
        }
        ++row;
    }
    effect.air.enabled = unit(seed, 1) < 0.8F;
    effect.air.fit = unit(seed, 2) < 0.7F;
    return effect;
}

/// What costs time, and nothing else, as small as it may be.
Effect made(Effect effect)
{
    effect.emitter.count = std::min(effect.emitter.count, kParticles);
    effect.air.resolution = std::min(effect.air.resolution, kCells);
    effect.noise.resolution = 8;
    effect.noise.slices = 1;
    effect.noise.octaves = 1;
    effect.light.resolution = std::min(effect.light.resolution, 16);
    effect.output.supersample = 1;
    effect.timeline.stepsPerFrame = std::min(effect.timeline.stepsPerFrame, 2);
    effect.timeline.length = std::min(effect.timeline.length, 20);
    const float steps = static_cast<float>(effect.timeline.frameRate * effect.timeline.stepsPerFrame);
    effect.life.fadeRate = std::max(effect.life.fadeRate, effect.life.initialAlpha * steps / kMaxSteps);
    return effect;
}

bool isPicture(const Image& image)
{
    const auto row = static_cast<std::size_t>(image.width) * 4;
    for (int y = 0; y < image.height; ++y) {
        if (!std::all_of(image.row(y), image.row(y) + row, [](float value) { return std::isfinite(value); })) {
            return false;
        }
    }
    return true;
}

/// Whether a document becomes a picture of numbers, or a sentence that says what to change.
bool isShown(const Effect& document, int number)
{
    try {
        const SampledEffect effect = sampled(document);
        Simulator simulator(effect);
        const auto frame = simulator.frame(number);
        if (!frame) {
            return frame.error().code == ErrorCode::OutOfRange && !frame.error().text().empty();
        }
        Renderer renderer;
        Image image;
        const Status status = renderer.render(*frame.value(), effect, kEdge, kEdge, image);
        if (!status) {
            qWarning("%s", status.error().text().c_str());
        }
        return status && isPicture(image);
    } catch (const std::exception& thrown) {
        qWarning("%s", thrown.what());
        return false;
    }
}

/// The smoke of a point in air that nothing moves.
Effect pointInStillAir()
{
    Effect effect;
    effect.emitter = {};
    effect.emitter.radius = 0.0F;
    effect.emitter.speed = 0.0F;
    effect.wind.strength = 0.0F;
    effect.turbulence.strength = 0.0F;
    effect.air.enabled = true;
    return effect;
}

/// Sources without extent of each shape, with and without what moves their air.
std::vector<Effect> pointSources()
{
    std::vector<Effect> points;
    for (int shape = 0; shape < 3; ++shape) {
        for (int i = 0; i < 64; ++i) {
            Effect effect = pointInStillAir();
            effect.emitter.shape = static_cast<EmitterShape>(shape);
            effect.emitter.width = (i & 1) != 0 ? 0.0F : 0.4F;
            effect.emitter.depth = 0.0F;
            effect.emitter.mode = (i & 2) != 0 ? EmissionMode::Burst : EmissionMode::Continuous;
            effect.emitter.speed = (i & 4) != 0 ? 0.09F : 0.0F; // as fast as air of no buoyancy is taken to rise
            effect.emitter.normal = (i & 8) != 0 ? glm::vec3(0.0F, -1.0F, 0.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
            effect.motion.buoyancy = effect.air.buoyancy = (i & 16) != 0 ? 0.0F : 2.0F;
            effect.emitter.position = (i & 32) != 0 ? glm::vec3(10000.0F, -10000.0F, 10000.0F) : glm::vec3(0.0F);
            points.push_back(effect);
        }
    }
    return points;
}

int tellingFrame(const Effect& effect)
{
    return std::min(19, effect.timeline.length - 1);
}

} // namespace

class AnySmokeTest : public QObject {
    Q_OBJECT

private slots:
    void aPointInStillAirIsShown()
    {
        for (const Effect& effect : pointSources()) {
            const Effect small = made(effect);
            Simulator simulator(sampled(small));
            QVERIFY(simulator.frame(tellingFrame(small)));
            QVERIFY(isShown(small, tellingFrame(small)));
        }
    }

    void everyDocumentIsShownOrRefused()
    {
        for (int i = 0; i < smokesOfAKind(); ++i) {
            const Effect effect = made(anyDocument(static_cast<std::uint32_t>(i)));
            QVERIFY2(isShown(effect, tellingFrame(effect)), qPrintable(QString::number(i)));
        }
    }

    /// Every smoke is a wild variation of the one before it; a line begins at each built-in preset and at each point
    /// source.
    void everyVariationOfVariationsIsShownOrRefused()
    {
        std::vector<Effect> parents;
        for (const LibraryEntry& entry : builtinPresets()) {
            parents.push_back(loadPreset(entry).value().preset.effect);
        }
        parents.push_back(pointInStillAir());
        for (int i = 0; i < smokesOfAKind(); ++i) {
            Effect& parent = parents[static_cast<std::size_t>(i) % parents.size()];
            constexpr float kWild = 0.4F;
            parent = vary(parent, kWild, static_cast<std::uint32_t>(i));
            const Effect effect = made(parent);
            QVERIFY2(isShown(effect, tellingFrame(effect)), qPrintable(QString::number(i)));
        }
    }

    void aParticleThatIsNowhereIsAnError()
    {
        for (const float place : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
            const Effect effect = made(pointInStillAir());
            Simulator simulator(sampled(effect));
            Frame frame = *simulator.frame(10).value();
            const auto living = static_cast<std::size_t>(
                std::find_if(frame.particles.birthStep.begin(), frame.particles.birthStep.end(),
                    [](std::int32_t step) { return step >= 0; })
                - frame.particles.birthStep.begin());
            frame.particles.x[living + 3] = place;
            Renderer renderer;
            Image image;
            const Status status = renderer.render(frame, sampled(effect), kEdge, kEdge, image);
            QVERIFY(!status);
            QCOMPARE(status.error().code, ErrorCode::OutOfRange);
        }
    }
};

QTEST_GUILESS_MAIN(AnySmokeTest)
#include "any_smoke_test.moc"
