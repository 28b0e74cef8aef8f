// What particles cover in pictures is what shadows and volumes find of them, whatever their mask and texture.
#include "tests/lighting/clouds.h"

#include "core/export/data/volume.h"
#include "core/rendering/renderer.h"

#include <algorithm>
#include <cmath>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr std::size_t kCount = 4000;
constexpr int kEdge = 400; // pixels
constexpr double kDistance = 20.0; // m

/// Thin particles in a plane that the camera looks at from the front.
Frame sheet(const Effect& effect)
{
    std::vector<glm::vec3> places;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        places.emplace_back(2.0F * unitFloat(streamBits(i, 1)) - 1.0F, 2.0F * unitFloat(streamBits(i, 2)) - 1.0F, 0.0F);
    }
    return cloud(effect, places);
}

Effect seenFromTheFront()
{
    Effect effect = evenLook();
    effect.look.opacity = 0.1F; // times 0.1: so thin that a particle's optical depth is its alpha
    effect.look.overlap = 0.0F;
    effect.look.rotationVariance = 1.0F;
    effect.noise.basis = NoiseBasis::Gradient;
    effect.light.direction = {0.0F, 0.0F, -1.0F};
    effect.light.shadow = 1.0F;
    effect.camera = {};
    effect.camera.target = {0.0F, 0.0F, 0.0F};
    effect.camera.distance = static_cast<float>(kDistance);
    effect.camera.pitch = 0.0F;
    return effect;
}

/// Extinction times volume, m^2.
template <class Densities>
double crossSection(const Densities& densities, std::size_t cells, float edge)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < cells; ++i) {
        sum += static_cast<double>(densities[i]);
    }
    return sum * std::pow(static_cast<double>(edge), 3.0);
}

/// Optical depth times area, m^2.
double coveredIn(const Image& image, const View& view)
{
    double sum = 0.0;
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
        sum -= std::log1p(-static_cast<double>(image.pixels[i]));
    }
    return sum * std::pow(kDistance / static_cast<double>(view.focal), 2.0);
}

} // namespace

class CoverageTest : public QObject {
    Q_OBJECT

private slots:
    void lightAndVolumesFindWhatPicturesShow_data()
    {
        QTest::addColumn<bool>("square");
        QTest::addColumn<float>("softness");
        QTest::addColumn<float>("texture");
        QTest::addColumn<float>("erosion");
        QTest::addColumn<float>("size");
        for (const float size : {0.03F, 0.12F, 1.2F}) { // of a pixel's, plain, and with a texture
            for (const float texture : {0.0F, 0.35F, 1.0F}) {
                for (const float erosion : {0.0F, 0.4F}) {
                    for (const float softness : {0.0F, 0.3F, 0.8F, 1.0F}) {
                        QTest::addRow("disc %g texture %g erosion %g size %g", static_cast<double>(softness),
                            static_cast<double>(texture), static_cast<double>(erosion), static_cast<double>(size))
                            << false << softness << texture << erosion << size;
                    }
                    QTest::addRow("square texture %g erosion %g size %g", static_cast<double>(texture),
                        static_cast<double>(erosion), static_cast<double>(size))
                        << true << 1.0F << texture << erosion << size;
                }
            }
        }
    }
    void lightAndVolumesFindWhatPicturesShow()
    {
        QFETCH(bool, square);
        QFETCH(float, softness);
        QFETCH(float, texture);
        QFETCH(float, erosion);
        QFETCH(float, size);
        Effect effect = seenFromTheFront();
        effect.look.mask = square ? MaskShape::Square : MaskShape::Disc;
        effect.look.softness = softness;
        effect.look.texture = texture;
        effect.look.erosion = erosion;
        effect.look.size = size;
        effect.noise.sharpness = 4.0F;
        Frame frame = sheet(effect);
        age(frame, 0.5F);
        Renderer& renderer = m_renderer;
        Image image;
        QVERIFY(renderer.render(frame, sampled(effect), kEdge, kEdge, image).ok());
        const double shown = coveredIn(image, renderer.batch().view);
        const double shaded =
            crossSection(renderer.light().density, renderer.light().shape.cells(), renderer.light().shape.cell);
        const Volume volume = volumeOf(frame, sampled(effect), 0.05F).value();
        const double kept = crossSection(volume.density, volume.count(), volume.cell);
        QVERIFY(shown > 0.0);
        QVERIFY2(near(shaded / shown, 1.0, 0.03), "light");
        QVERIFY2(near(kept / shown, 1.0, 0.03), "volume");
    }

    void meansOfMasksAreThoseOfTheirProfiles()
    {
        Look look;
        for (const float softness : {0.0F, 0.1F, 0.5F, 0.8F, 1.0F}) {
            look.softness = softness;
            constexpr int kSteps = 100'000;
            double sum = 0.0;
            for (int i = 0; i < kSteps; ++i) {
                const double r2 = (i + 0.5) / kSteps; // even over the disc
                sum += std::pow(std::clamp((1.0 - r2) / std::max(0.02, static_cast<double>(softness)), 0.0, 1.0), 2.0)
                    / kSteps;
            }
            QVERIFY(near(maskMean(look), sum, 1e-5));
        }
        QCOMPARE(maskMean(look), 1.0F / 3.0F);
        QCOMPARE(coverageOf(look, {}).mean, 1.0F / 3.0F);
        look.mask = MaskShape::Square;
        QVERIFY(near(maskMean(look), 4.0 / M_PI, 1e-6));
    }

private:
    Renderer m_renderer; // keeps the noise texture from one row to the next
};

QTEST_GUILESS_MAIN(CoverageTest)
#include "coverage_test.moc"
