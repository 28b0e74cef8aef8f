// The map of what glows: nothing where nothing does, and with its gradient and its scale the colours of the emission
// pass.

#include "tests/helpers.h"

#include "core/export/glow_ramp.h"
#include "core/export/sheets/sheet.h"
#include "core/preset/library.h"

#include <algorithm>
#include <cmath>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr double kMinDecibels = 30.0; // of the brightest; eight bits in squares, one hue at each brightness

/// The passes of what glows, of few particles in coarse air: a colour and a map do not depend on their number.
struct Glowing {
    PassSheet sheet;
    PassPictures pictures;

    static constexpr PassSet kPasses{Pass::Alpha, Pass::SixWayB, Pass::Emission, Pass::Temperature};
    explicit Glowing(PassSheet made)
        : sheet(std::move(made))
        , pictures(sheet, kPasses, {})
    {
    }
    [[nodiscard]] float alpha(std::size_t pixel) const
    {
        return sheet.targets.of(PassTarget::Colour).pixels[pixel * 4 + 3];
    }
};

Effect small(Effect effect)
{
    effect.emitter.count = std::min(effect.emitter.count, 3000);
    effect.air.resolution = 16;
    effect.noise.resolution = 16;
    effect.noise.slices = 4;
    effect.output.quality = Quality::Good;
    effect.output.supersample = 1;
    effect.output.width = 48;
    effect.output.height = 48;
    effect.timeline.loop = false;
    return effect;
}

PassSheet sheetOf(const Effect& effect)
{
    const int length = effect.timeline.length;
    PassSheet sheet;
    if (const Status status = renderSheet(effect, {{length / 8, length / 2}}, 2, Glowing::kPasses, sheet, {});
        !status) {
        qFatal("%s", status.error().text().c_str());
    }
    return sheet;
}

void addPresets()
{
    QTest::addColumn<QString>("preset");
    for (const LibraryEntry& entry : builtinPresets()) {
        QTest::newRow(entry.id.c_str()) << QString::fromStdString(entry.id);
    }
}

float largest(const DataImage& image, int channel)
{
    float most = 0.0F;
    for (std::size_t i = static_cast<std::size_t>(channel); i < image.values.size();
         i += static_cast<std::size_t>(image.channels)) {
        most = std::max(most, image.values[i]);
    }
    return most;
}

/// As a picture of eight bits stores it.
float stored(float value)
{
    return std::round(std::clamp(value, 0.0F, 1.0F) * 255.0F) / 255.0F;
}

} // namespace

class GlowTest : public QObject {
    Q_OBJECT

private slots:
    void coldSmokeDoesNotGlow_data() { addPresets(); }
    void coldSmokeDoesNotGlow()
    {
        QFETCH(QString, preset);
        Effect effect = small(loadPreset(preset.toStdString()).value().preset.scene.effect());
        effect.glow.emission = 0.0F;
        const Glowing cold(sheetOf(effect));
        QVERIFY(largest(cold.pictures.picture(Pass::SixWayB), 0) > 0.0F); // there is smoke, in light
        QCOMPARE(largest(cold.pictures.picture(Pass::SixWayB), 3), 0.0F);
        QCOMPARE(largest(cold.pictures.picture(Pass::Temperature), 0), 0.0F);
        QCOMPARE(cold.pictures.scales().glow, 0.0F);
        QVERIFY(cold.pictures.scales().ramp == GlowRamp());
    }

    void blackSootDoesNotGlow()
    {
        Effect effect = small(loadPreset("campfire").value().preset.scene.effect());
        effect.glow.emission = 5.0F;
        effect.glow.emissionColour = EmissionColour::Gradient;
        effect.glow.emissionGradient = Gradient{{0.0F, glm::vec3(0.0F)}, {1.0F, glm::vec3(0.0F)}};
        const Glowing soot(sheetOf(effect));
        QCOMPARE(largest(soot.pictures.picture(Pass::SixWayB), 3), 0.0F);
        QCOMPARE(largest(soot.pictures.picture(Pass::Temperature), 0), 0.0F);
    }

    void theMapAndItsGradientMakeTheEmission_data() { addPresets(); }
    void theMapAndItsGradientMakeTheEmission()
    {
        QFETCH(QString, preset);
        Effect effect = small(loadPreset(preset.toStdString()).value().preset.scene.effect());
        const bool burns = effect.glow.emission > 0.0F;
        effect.glow.emission = std::max(effect.glow.emission, 2.0F);
        const Glowing fire(sheetOf(effect));
        const DataImage map = fire.pictures.picture(Pass::SixWayB);
        const DataImage emission = fire.pictures.picture(Pass::Emission);
        const PassScales& scales = fire.pictures.scales();
        QVERIFY2(largest(map, 3) > 254.0F / 255.0F, std::to_string(largest(map, 3)).c_str()); // all bits are used
        const float hottest = largest(fire.pictures.picture(Pass::Temperature), 0);
        QVERIFY(hottest > 254.0F / 255.0F || hottest == 0.0F); // what is lit by fire need not glow itself
        double error = 0.0;
        double weight = 0.0;
        for (std::size_t i = 0; i < map.values.size() / 4; ++i) {
            const glm::vec3 seen = glowColour(scales.ramp, stored(map.values[i * 4 + 3])) * scales.glow;
            const double alpha = fire.alpha(i);
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const double difference =
                    seen[static_cast<int>(channel)] - emission.values[i * 4 + channel] * scales.emission;
                error += alpha * difference * difference / 3.0;
            }
            weight += alpha;
        }
        const double decibels = -10.0 * std::log10(error / weight / (static_cast<double>(scales.glow) * scales.glow));
        qInfo("%s: %.1f dB", qPrintable(preset), decibels);
        // Cold smoke that is set alight has no colours that were made for it: places of several heats in one pixel are
        // of another hue than its brightness says.
        QVERIFY2(!burns || decibels > kMinDecibels, std::to_string(decibels).c_str());
    }

    void fireIsHotWhereItGlows()
    {
        const Glowing fire(sheetOf(small(loadPreset("campfire").value().preset.scene.effect())));
        const DataImage heat = fire.pictures.picture(Pass::Temperature);
        QVERIFY(near(largest(heat, 0), 1.0, 1e-6));
        QVERIFY(fire.pictures.scales().temperature > 0.1F && fire.pictures.scales().temperature <= 1.0F);
        const auto soot = std::count(heat.values.begin(), heat.values.end(), 0.0F);
        QVERIFY2(soot > 100, qPrintable(QString::number(soot))); // above it
    }

    void brightnessComesBackFromItsPosition()
    {
        float before = -1.0F;
        for (int i = 0; i <= 1000; ++i) {
            const float brightness = static_cast<float>(i) / 1000.0F;
            const float position = glowPosition(brightness);
            QVERIFY(position > before && near(glowBrightness(position), brightness, 1e-6));
            before = position;
        }
        for (int k = 0; k < kGlowKeys; ++k) {
            const float at = glowKeyPosition(k);
            QVERIFY(near(glowPosition(at * at), at, 1e-6)); // keys stand at squares
        }
        QCOMPARE(glowPosition(-1.0F), 0.0F);
        QCOMPARE(glowPosition(7.0F), 1.0F);
    }

    void aPictureOfOneHueComesBackWhole()
    {
        const glm::vec3 hue(1.0F, 0.5F, 0.125F);
        Image image;
        image.resize(64, 2);
        for (std::size_t i = 0; i < image.pixels.size() / 4; ++i) {
            const float brightness = static_cast<float>(i % 64) / 63.0F;
            for (int channel = 0; channel < 3; ++channel) {
                image.pixels[i * 4 + static_cast<std::size_t>(channel)] = 8.0F * brightness * hue[channel];
            }
            image.pixels[i * 4 + 3] = i < 64 ? 1.0F : 0.25F;
        }
        const GlowRamp ramp = fitGlowRamp(image, 8.0F);
        for (int i = 0; i <= 100; ++i) {
            const float brightness = static_cast<float>(i) / 100.0F;
            const glm::vec3 colour = glowColour(ramp, glowPosition(brightness));
            QVERIFY(near(colour.r, brightness, 1e-5) && near(colour.g, 0.5 * brightness, 1e-5)
                && near(colour.b, 0.125 * brightness, 1e-5));
        }
    }
};

QTEST_GUILESS_MAIN(GlowTest)
#include "glow_test.moc"
