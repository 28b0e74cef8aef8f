// What light is shown as: the curve of sRGB, views, exposure, backgrounds, and flames, which are clear.

#include "tests/helpers.h"

#include "core/base/math.h"
#include "core/rendering/view_transform.h"

#include <algorithm>
#include <cmath>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// One particle, as hot as at birth, in no other light.
Effect loneFlame()
{
    Effect effect = thesisEffect(1);
    effect.emitter.mode = EmissionMode::Burst;
    effect.emitter.speed = 0.0F;
    effect.emitter.width = effect.emitter.depth = 0.0F;
    effect.life.alphaCurve = Curve{{0.0F, 1.0F}};
    effect.motion.heatVariance = 0.0F;
    effect.light.intensity = 0.0F;
    effect.light.ambient = 0.0F;
    effect.light.occlusion = 0.0F; // nothing hides the sky
    effect.glow.emission = 3.0F;
    effect.glow.emissionCooling = 0.0F;
    effect.camera.target = {0.0F, 0.0F, 0.0F};
    effect.output.width = effect.output.height = 64;
    return effect;
}

glm::vec4 sumOf(const Image& image)
{
    glm::vec4 sum(0.0F);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            sum += image.at(x, y);
        }
    }
    return sum;
}

} // namespace

class ShownLightTest : public QObject {
    Q_OBJECT

private slots:
    void srgbCurveMeetsTheStandard()
    {
        QVERIFY(std::abs(srgbFromLinear(0.0F)) < 1e-7F);
        QVERIFY(std::abs(srgbFromLinear(1.0F) - 1.0F) < 1e-6F);
        QVERIFY(std::abs(srgbFromLinear(0.5F) - 0.735357F) < 1e-5F);
        QVERIFY(std::abs(srgbFromLinear(0.001F) - 0.01292F) < 1e-6F);
    }

    void encodingIsStraightAlphaWithExposure()
    {
        Image image;
        image.resize(2, 1);
        const float pixels[] = {0.1F, 0.05F, 0.0F, 0.2F, 0.0F, 0.0F, 0.0F, 0.0F};
        std::copy_n(pixels, 8, image.pixels.begin());
        Output output;
        EncodedImage<std::uint8_t> out;
        encode(image, output, out);
        QCOMPARE(int(out.pixels[0]), 188); // sRGB of 0.5
        QCOMPARE(int(out.pixels[1]), 137); // of 0.25
        QCOMPARE(int(out.pixels[3]), 51);
        for (int i = 4; i < 8; ++i) {
            QCOMPARE(int(out.pixels[static_cast<std::size_t>(i)]), 0);
        }
        output.exposure = 1.0F;
        EncodedImage<std::uint16_t> wide;
        encode(image, output, wide);
        QCOMPARE(int(wide.pixels[0]), 65535);
        QVERIFY(std::abs(int(wide.pixels[1]) - int(65535.0F * srgbFromLinear(0.5F) + 0.5F)) <= 1);
    }

    void rimOfAHotCoreIsDark()
    {
        Effect effect = loneFlame();
        effect.glow.hotCore = 0.0F;
        const float without = sumOf(render(effect, 0)).r;
        effect.glow.hotCore = 1.0F;
        const float with = sumOf(render(effect, 0)).r;
        QVERIFY(without > 0.0F);
        QVERIFY2(with < 0.05F * without, qPrintable(QString("%1 %2").arg(with).arg(without)));
    }

    void flamesAreClearAndSootIsNot()
    {
        Effect effect = loneFlame();
        const glm::vec4 lava = sumOf(render(effect, 0));
        effect.glow.flameOpacity = 0.1F;
        const glm::vec4 flame = sumOf(render(effect, 0));
        // A lone particle hides nothing: it gives as much light through a tenth of the smoke.
        QVERIFY2(std::abs(flame.r - lava.r) < 1e-3F * lava.r, qPrintable(QString("%1 %2").arg(flame.r).arg(lava.r)));
        QVERIFY2(
            std::abs(flame.a - 0.1F * lava.a) < 1e-3F * lava.a, qPrintable(QString("%1 %2").arg(flame.a).arg(lava.a)));
        // At once cold, or with nothing that glows, it is smoke as any other.
        effect.glow.emissionCooling = 100.0F;
        effect.glow.flameOpacity = 1.0F;
        const glm::vec4 smoke = sumOf(render(effect, 10));
        effect.glow.flameOpacity = 0.1F;
        QCOMPARE(sumOf(render(effect, 10)), smoke);
        effect.glow.emission = 0.0F;
        QCOMPARE(sumOf(render(effect, 0)).a, lava.a);
    }

    void flamesLieOverEachOther()
    {
        // The one behind shines through the one in front, and their light adds up.
        constexpr int kBothBorn = 10;
        Effect effect = loneFlame();
        effect.look.opacity = 100.0F;
        effect.look.texture = 0.0F;
        effect.look.size = 2.0F; // many pixels
        effect.look.sizeVariance = 0.0F;
        effect.look.overlap = 0.0F;
        const float one = sumOf(render(effect, kBothBorn)).r;
        effect.emitter.count = 2;
        const float lava = sumOf(render(effect, kBothBorn)).r;
        QVERIFY2(lava > one && lava < 1.6F * one, qPrintable(QString("%1 %2").arg(lava).arg(one)));
        effect.glow.flameOpacity = 0.01F;
        const float flames = sumOf(render(effect, kBothBorn)).r;
        QVERIFY2(flames > 1.95F * one && flames < 2.001F * one, qPrintable(QString("%1 %2").arg(flames).arg(one)));
    }

    void theBackgroundIsTheChosenColourInEveryViewAndExposure()
    {
        Image image; // nothing, thin smoke and opaque smoke
        image.resize(3, 1);
        const std::array<float, 12> pixels{0.0F, 0.0F, 0.0F, 0.0F, 0.05F, 0.05F, 0.05F, 0.1F, 0.4F, 0.4F, 0.4F, 1.0F};
        std::copy(pixels.begin(), pixels.end(), image.pixels.begin());
        for (const glm::vec3& colour : {glm::vec3(0.05F, 0.1F, 0.18F), glm::vec3(0.0F, 1.0F, 0.0F), glm::vec3(1.0F),
                 glm::vec3(0.0F), glm::vec3(0.9F, 0.02F, 0.5F)}) {
            for (const ViewTransform transform : {ViewTransform::Standard, ViewTransform::Filmic}) {
                for (const float exposure : {-8.0F, -1.0F, 0.0F, 0.5F, 3.0F, 8.0F}) {
                    Output output;
                    output.viewTransform = transform;
                    output.exposure = exposure;
                    EncodedImage<std::uint16_t> clear;
                    encode(image, output, clear);
                    output.background = Background::Colour;
                    output.backgroundColour = colour;
                    EncodedImage<std::uint8_t> bytes;
                    EncodedImage<std::uint16_t> words;
                    EncodedImage<std::uint8_t> over;
                    encode(image, output, bytes);
                    encode(image, output, words);
                    encodeOver(image, output, {colour, {}, 0}, over);
                    QVERIFY(sameBits(bytes.pixels, over.pixels));
                    for (int channel = 0; channel < 3; ++channel) {
                        const auto at = static_cast<std::size_t>(channel);
                        const float shown = srgbFromLinear(colour[channel]);
                        QCOMPARE(int(bytes.pixels[at]), static_cast<int>(shown * 255.0F + 0.5F));
                        QVERIFY(std::abs(int(words.pixels[at]) - static_cast<int>(shown * 65535.0F + 0.5F)) <= 1);
                        // Smoke as in transparent pictures, in front of it.
                        const float smoke = linearFromSrgb(static_cast<float>(clear.pixels[4 + at]) / 65535.0F);
                        const float mixed = srgbFromLinear(0.1F * smoke + 0.9F * colour[channel]);
                        QVERIFY(exposure > 0.5F
                            || std::abs(static_cast<float>(words.pixels[4 + at]) / 65535.0F - mixed) < 2e-3F);
                        QCOMPARE(words.pixels[8 + at], clear.pixels[8 + at]);
                    }
                    QCOMPARE(bytes.pixels[3], std::uint8_t{255});
                    QCOMPARE(bytes.pixels[7], std::uint8_t{255});
                }
            }
        }
    }

    void filmicKeepsHuesAndGoesOverIntoWhite_data()
    {
        QTest::addColumn<glm::vec3>("colour");
        QTest::newRow("orange") << glm::vec3(1.0F, 0.4F, 0.05F);
        QTest::newRow("red") << glm::vec3(1.0F, 0.02F, 0.01F);
        QTest::newRow("green") << glm::vec3(0.05F, 1.0F, 0.1F);
        QTest::newRow("blue") << glm::vec3(0.02F, 0.1F, 1.0F);
        QTest::newRow("one channel") << glm::vec3(0.0F, 0.0F, 1.0F);
        QTest::newRow("violet") << glm::vec3(0.6F, 0.1F, 0.9F);
    }
    void filmicKeepsHuesAndGoesOverIntoWhite()
    {
        QFETCH(glm::vec3, colour);
        const auto hue = [](const glm::dvec3& c) {
            return std::atan2(std::sqrt(3.0) * (c.g - c.b), 2.0 * c.r - c.g - c.b) * 180.0 / M_PI;
        };
        Output output;
        output.viewTransform = ViewTransform::Filmic;
        double saturation = 2.0;
        glm::dvec3 before(-1.0);
        for (float stops = -4.0F; stops <= 8.0F; stops += 0.25F) {
            output.exposure = stops;
            Image image;
            image.resize(1, 1);
            image.pixels = {colour.r, colour.g, colour.b, 1.0F};
            EncodedImage<std::uint16_t> encoded;
            encode(image, output, encoded);
            glm::dvec3 shown(0.0);
            for (int i = 0; i < 3; ++i) {
                shown[i] = static_cast<double>(
                    linearFromSrgb(static_cast<float>(encoded.pixels[static_cast<std::size_t>(i)]) / 65535.0F));
            }
            const double most = std::max({shown.r, shown.g, shown.b});
            const double least = std::min({shown.r, shown.g, shown.b});
            if (stops <= 3.0F) {
                const double turned = std::remainder(hue(shown) - hue(glm::dvec3(colour)), 360.0);
                QVERIFY2(std::abs(turned) < 1.0,
                    qPrintable(QString("%1 stops: %2 degrees").arg(static_cast<double>(stops)).arg(turned)));
            }
            QVERIFY((most - least) / most <= saturation + 1e-3);
            saturation = (most - least) / most;
            for (int i = 0; i < 3; ++i) {
                QVERIFY(shown[i] >= before[i] - 1e-4); // more light never shows as less
            }
            before = shown;
        }
        QVERIFY(saturation < 0.01); // white in the end
    }

    void lightBeyondWhatIsShownLooksTheSame()
    {
        for (const ViewTransform transform : {ViewTransform::Standard, ViewTransform::Filmic}) {
            for (const float exposure : {-1.0F, 0.0F, 2.5F}) {
                Output output;
                output.viewTransform = transform;
                output.exposure = exposure;
                const float brightest = brightestShown(output);
                Image image;
                image.resize(3, 1);
                const std::array<float, 3> lights{0.98F * brightest, 1.001F * brightest, 100.0F * brightest};
                for (std::size_t i = 0; i < lights.size(); ++i) {
                    std::fill_n(image.pixels.begin() + static_cast<std::ptrdiff_t>(4 * i), 3, lights[i]);
                    image.pixels[4 * i + 3] = 1.0F;
                }
                EncodedImage<std::uint16_t> shown;
                encode(image, output, shown);
                QVERIFY(shown.pixels[0] < 65535);
                QCOMPARE(shown.pixels[4], std::uint16_t{65535});
                QCOMPARE(shown.pixels[8], std::uint16_t{65535});
            }
        }
    }

    void filesShowTheLightOfClearFlames()
    {
        // Premultiplied: a clear flame, smoke, what glows a little, a hot flame, and thin smoke.
        const std::vector<glm::vec4> pixels{{0.3F, 0.1F, 0.02F, 0.02F}, {0.1F, 0.1F, 0.1F, 0.5F},
            {0.022F, 0.01F, 0.01F, 0.02F}, {9.0F, 3.0F, 0.5F, 0.1F}, {0.008F, 0.008F, 0.008F, 0.01F}};
        Image image;
        image.resize(static_cast<int>(pixels.size()), 1);
        std::memcpy(image.pixels.data(), pixels.data(), pixels.size() * sizeof(glm::vec4));
        for (const ViewTransform transform : {ViewTransform::Standard, ViewTransform::Filmic}) {
            Output output;
            output.viewTransform = transform;
            EncodedImage<std::uint16_t> plain;
            EncodedImage<std::uint16_t> covered;
            encode(image, output, plain);
            encode(image, output, covered, Cover::Light);
            Image opaque = image;
            fillBackground(opaque, glm::vec3(0.0F));
            EncodedImage<std::uint16_t> overBlack;
            encode(opaque, output, overBlack);
            const auto at = [](const EncodedImage<std::uint16_t>& of, std::size_t pixel, std::size_t channel) {
                return of.pixels[pixel * 4 + channel] / 65535.0;
            };
            for (const std::size_t flame : {0U, 3U}) {
                for (std::size_t channel = 0; channel < 3; ++channel) {
                    QVERIFY(
                        std::abs(at(covered, flame, channel) * at(covered, flame, 3) - at(overBlack, flame, channel))
                        < 1e-4);
                }
                QVERIFY(at(covered, flame, 3) > 5.0 * static_cast<double>(pixels[flame].a));
            }
            for (const std::size_t same : {1U, 4U}) {
                QVERIFY(std::equal(plain.pixels.begin() + 4 * static_cast<std::ptrdiff_t>(same),
                    plain.pixels.begin() + 4 * static_cast<std::ptrdiff_t>(same + 1),
                    covered.pixels.begin() + 4 * static_cast<std::ptrdiff_t>(same)));
            }
            // From what alpha covers to what it does not nothing jumps.
            QVERIFY(std::abs(at(covered, 2, 0) * at(covered, 2, 3) - at(plain, 2, 0) * at(plain, 2, 3)) < 0.03);
        }
    }
};

QTEST_GUILESS_MAIN(ShownLightTest)
#include "shown_light_test.moc"
