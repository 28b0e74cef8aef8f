// What an explosion gives off in a picture hardly depends on how many steps a second has.
#include "tests/helpers.h"

#include "core/lighting/glow.h"
#include "core/preset/library.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kEdge = 48;
constexpr std::array kRates{24, 30, 60, 120};
/// When it is looked at, s: whole frames at all rates.
constexpr std::array kTimes{1.0 / 6.0, 1.0 / 3.0};

/// With little to compute, and no light but its own.
Effect glowAlone()
{
    Effect effect = loadPreset(std::string("explosion")).value().preset.scene.effect();
    effect.air.resolution = 32;
    effect.emitter.count = 1000;
    effect.timeline.loop = false;
    effect.light.intensity = 0.0F;
    effect.light.ambient = 0.0F;
    effect.light.resolution = 24;
    effect.glow.fireLight = 0.0F;
    effect.look.detail = 0.0F;
    effect.noise.resolution = 32;
    effect.noise.slices = 1;
    return effect;
}

double luminance(const Image& image)
{
    double sum = 0.0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            sum += static_cast<double>(glm::dot(glm::vec3(image.at(x, y)), kLuminance));
        }
    }
    return sum;
}

using Glows = std::array<double, kTimes.size()>;

/// Sums of the pictures, the mean of seeds, so that chance does not decide.
Glows glowsAt(int rate)
{
    Glows out{};
    constexpr int kSeeds = 8;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        Effect effect = glowAlone();
        effect.timeline.frameRate = rate;
        effect.emitter.seed = static_cast<std::uint32_t>(seed);
        Simulator simulator(sampled(effect));
        Renderer renderer;
        Image image;
        for (std::size_t i = 0; i < kTimes.size(); ++i) {
            const auto frame = simulator.frame(static_cast<int>(std::lround(kTimes[i] * rate)));
            if (!frame || !renderer.render(*frame.value(), sampled(effect), kEdge, kEdge, image)) {
                return {};
            }
            out[i] += luminance(image) / kSeeds;
        }
    }
    return out;
}

} // namespace

class ExplosionGlowTest : public QObject {
    Q_OBJECT

private slots:
    void aPictureIsAsBrightAtEveryFrameRate()
    {
        std::array<Glows, kRates.size()> all{};
        Glows mean{};
        for (std::size_t rate = 0; rate < kRates.size(); ++rate) {
            all[rate] = glowsAt(kRates[rate]);
            for (std::size_t i = 0; i < kTimes.size(); ++i) {
                mean[i] += all[rate][i] / static_cast<double>(kRates.size());
            }
        }
        for (std::size_t i = 0; i < kTimes.size(); ++i) {
            for (std::size_t rate = 0; rate < kRates.size(); ++rate) {
                qInfo("%.2f s, %d/s: %.2f of %.2f", kTimes[i], kRates[rate], all[rate][i], mean[i]);
                QVERIFY(near(all[rate][i] / mean[i], 1.0, 0.1));
            }
        }
    }
};

QTEST_GUILESS_MAIN(ExplosionGlowTest)
#include "explosion_glow_test.moc"
