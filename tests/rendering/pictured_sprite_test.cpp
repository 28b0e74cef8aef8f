// Particles that look like a picture: where its pixels come to lie, what they cover, and which colours they have.

#include "tests/helpers.h"
#include "tests/pictures.h"

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/lighting/coverage.h"
#include "core/rendering/layer_pictures.h"
#include "core/rendering/pass_renderer.h"
#include "core/rendering/scene_renderer.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

using Rgba = std::array<std::uint8_t, 4>;

constexpr Rgba kWhite{255, 255, 255, 255};
constexpr Rgba kClear{255, 255, 255, 0};

/// One particle in light of its own alone, 20 pixels from its middle to its edge, in the middle of the picture.
Effect loneParticle(const Bitmap& picture)
{
    Effect effect = thesisEffect(1);
    effect.emitter.mode = EmissionMode::Burst;
    effect.emitter.burstDuration = 0.0F;
    effect.emitter.speed = 0.0F;
    effect.emitter.width = effect.emitter.depth = 0.0F;
    effect.life.alphaCurve = Curve{{0.0F, 1.0F}};
    effect.life.sizeCurve = Curve{{0.0F, 1.0F}};
    effect.look.sizeVariance = 0.0F;
    effect.look.rotationVariance = 0.0F;
    effect.look.spinVariance = 0.0F;
    effect.look.deformation = 0.0F;
    effect.look.texture = 0.0F;
    effect.look.opacity = 1.0F;
    effect.look.overlap = 0.0F;
    effect.look.dilution = 0.0F;
    effect.look.colour = glm::vec3(1.0F);
    effect.look.mask = MaskShape::Picture;
    effect.look.picture = picture;
    effect.light.intensity = 0.0F;
    effect.light.occlusion = 0.0F;
    effect.light.ambient = 1.0F;
    effect.light.sky = effect.light.ground = glm::vec3(1.0F);
    effect.camera.target = {0.0F, 0.0F, 0.0F};
    effect.camera.pitch = effect.camera.yaw = 0.0F;
    effect.output.width = effect.output.height = 64;
    const View view = makeView(effect.camera, 0.0F, 64, 64);
    effect.look.size = 1.0F;
    const auto radiusOf = [&] {
        Renderer renderer;
        (void)renderer.prepare(*frameOf(effect, 0), sampled(effect), view);
        return renderer.batch().sprites[0].halfWidth - kHalfEdge;
    };
    effect.look.size = 20.0F / radiusOf();
    return effect;
}

/// Several particles on a few layers, for what must hold of any.
Scene leavesInSmoke()
{
    Effect effect = everythingOn();
    effect.emitter.count = 3000;
    Scene scene = effect;
    effect.look.mask = MaskShape::Picture;
    effect.look.picture = pictureOf(24, 17, [](int x, int y) {
        return Rgba{static_cast<std::uint8_t>(10 * x), 120, static_cast<std::uint8_t>(255 - 12 * y),
            static_cast<std::uint8_t>((x + y) % 5 == 0 ? 0 : 200)};
    });
    effect.look.size *= 2.0F;
    effect.emitter.seed = 5;
    effect.emitter.count = 500;
    scene.layers.emplace_back();
    scene.assign(1, effect);
    return scene;
}

Image imageOf(const Scene& scene)
{
    SceneRenderer renderer(scene);
    Image image;
    if (!renderer.render(9, 96, 80, image)) {
        qFatal("render");
    }
    return image;
}

} // namespace

class PicturedSpriteTest : public QObject {
    Q_OBJECT

private slots:
    void pixelsLieWhereThePictureHasThem()
    {
        // Right half of the picture, and of that the upper half, in colours of its own.
        const Effect effect = loneParticle(pictureOf(16, 16, [](int x, int y) {
            return x < 8 ? kClear : y < 8 ? Rgba{255, 0, 0, 255} : Rgba{0, 0, 255, 255};
        }));
        const Image image = render(effect, 0);
        const glm::vec4 left = image.at(22, 32);
        const glm::vec4 upper = image.at(42, 22);
        const glm::vec4 lower = image.at(42, 42);
        QCOMPARE(left.a, 0.0F);
        QVERIFY(upper.a > 0.05F && near(upper.a, lower.a, 1e-6));
        QVERIFY(upper.r > 0.05F && upper.g == 0.0F && upper.b == 0.0F);
        QVERIFY(lower.b > 0.05F && lower.g == 0.0F && lower.r == 0.0F);
        QCOMPARE(image.at(32, 8).a, 0.0F);
    }

    void thePicturesLongerEdgeIsAsWideAsTheParticle()
    {
        const Image image =
            render(loneParticle(pictureOf(40, 10, [](int, int) { return kWhite; })), 0); // of 40 x 10 pixels there
        QVERIFY(image.at(14, 32).a > 0.05F && image.at(49, 32).a > 0.05F);
        QVERIFY(image.at(10, 32).a == 0.0F && image.at(53, 32).a == 0.0F);
        QVERIFY(image.at(32, 28).a > 0.05F && image.at(32, 35).a > 0.05F);
        QVERIFY(image.at(32, 24).a == 0.0F && image.at(32, 39).a == 0.0F);
    }

    void aWhitePictureIsASquare()
    {
        Effect effect = loneParticle(pictureOf(32, 32, [](int, int) { return kWhite; }));
        const Image picture = render(effect, 0);
        effect.look.mask = MaskShape::Square;
        const Image square = render(effect, 0);
        for (std::size_t i = 0; i < square.pixels.size(); ++i) {
            QVERIFY(near(picture.pixels[i], square.pixels[i], 2e-5));
        }
    }

    void withoutAPictureItIsASquareToTheBit()
    {
        Effect effect = everythingOn();
        effect.look.mask = MaskShape::Square;
        const Image square = render(effect, 9);
        effect.look.picture = ramp(4, 4);
        QVERIFY(sameBits(render(effect, 9).pixels, square.pixels)); // a square looks at no picture
        effect.look.mask = MaskShape::Picture;
        effect.look.picture = Bitmap();
        QVERIFY(sameBits(render(effect, 9).pixels, square.pixels));
    }

    void coloursAreThoseOfThePictureInLinearLight()
    {
        const Image white = render(loneParticle(pictureOf(4, 4, [](int, int) { return kWhite; })), 0);
        const Image grey = render(loneParticle(pictureOf(4, 4, [](int, int) { return Rgba{188, 64, 0, 255}; })), 0);
        const glm::vec4 one = white.at(32, 32);
        const glm::vec4 other = grey.at(32, 32);
        QVERIFY(near(other.a, one.a, 1e-6));
        QVERIFY(near(other.r / one.r, std::pow((188.0 / 255.0 + 0.055) / 1.055, 2.4), 1e-4));
        QVERIFY(near(other.g / one.g, std::pow((64.0 / 255.0 + 0.055) / 1.055, 2.4), 1e-4));
        QCOMPARE(other.b, 0.0F);
        const glm::vec4 thin = render(loneParticle(pictureOf(4, 4,
                                          [](int, int) {
                                              return Rgba{188, 64, 0, 51};
                                          })),
            0)
                                   .at(32, 32);
        QVERIFY(near(thin.a / other.a, 0.2, 1e-5));
        QVERIFY(near(thin.r / thin.a, other.r / other.a, 1e-4) && near(thin.g / thin.a, other.g / other.a, 1e-4));
    }

    /// Whatever its size in pixels: coarser levels are means.
    void itCoversItsMeanAlphaWhateverItsSize()
    {
        const Bitmap picture = pictureOf(48, 48, [](int x, int y) {
            return Rgba{255, 255, 255, static_cast<std::uint8_t>((x / 3 + y / 3) % 2 == 0 ? 255 : 40)};
        });
        QVERIFY(near(picture.opacity(), 0.5 * (1.0 + 40.0 / 255.0), 1e-6));
        const Effect large = loneParticle(picture);
        for (const float radius : {1.0F, 2.0F, 3.7F, 8.0F, 20.0F, 27.0F}) {
            Effect effect = large;
            effect.look.size *= radius / 20.0F;
            const View view = makeView(effect.camera, 0.0F, 64, 64);
            Renderer renderer;
            QVERIFY(renderer.prepare(*frameOf(effect, 0), sampled(effect), view).ok());
            Image image;
            QVERIFY(renderer.composite(image).ok());
            const Sprite& sprite = renderer.batch().sprites[0];
            double sum = 0.0;
            for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
                sum += static_cast<double>(image.pixels[i]);
            }
            const double side = 2.0 * static_cast<double>(sprite.halfWidth - kHalfEdge);
            const double expected = side * side * static_cast<double>(sprite.opacity * picture.opacity());
            QVERIFY2(near(sum / expected, 1.0, radius < 2.0F ? 0.08 : 0.03), qPrintable(QString::number(radius)));
        }
    }

    void finePatternsAreEvenFromAfar()
    {
        Effect effect =
            loneParticle(pictureOf(128, 128, [](int x, int /*y*/) { return x % 8 == 0 ? kWhite : kClear; }));
        effect.look.size *= 0.4F; // eight texels a pixel
        const Image image = render(effect, 0);
        const float opacity = 8.0F * image.at(32, 32).a;
        QVERIFY(opacity > 0.05F);
        for (int x = 27; x < 37; ++x) {
            QVERIFY(near(8.0F * image.at(x, 30).a, opacity, 0.02 * static_cast<double>(opacity)));
        }
        effect.look.picture = pictureOf(128, 128, [](int, int) { return kWhite; });
        QVERIFY(near(render(effect, 0).at(32, 32).a, opacity, 0.02 * static_cast<double>(opacity)));
    }

    void everyLevelHasTheMeanAlphaOfThePicture()
    {
        for (const auto& [width, height] : {std::pair{48, 21}, std::pair{1, 1}, std::pair{64, 64}, std::pair{5, 300}}) {
            const Bitmap picture = pictureOf(width, height, [](int x, int y) {
                return Rgba{200, 100, 50, static_cast<std::uint8_t>(x * 40 + y * 7)};
            });
            const SpritePicture levels(picture);
            QCOMPARE(levels.levelSize(levels.levels() - 1), 1);
            for (int level = 0; level < levels.levels(); ++level) {
                const int texels = levels.levelSize(level) * levels.levelSize(level);
                double sum = 0.0;
                for (int i = 0; i < texels; ++i) {
                    sum += static_cast<double>(levels.texels(level)[4 * i + 3]);
                }
                QVERIFY(near(sum / texels, picture.opacity(), 1e-5));
            }
        }
    }

    void lightFindsTheMeanAlphaOfThePicture()
    {
        Look look;
        look.mask = MaskShape::Picture;
        look.picture = pictureOf(10, 5, [](int x, int) { return x < 5 ? kWhite : kClear; }); // half of half a square
        QVERIFY(near(maskMean(look), 4.0 / 3.14159265 * 0.25, 1e-6));
        look.texture = 1.0F;
        look.erosion = 0.5F;
        GreyCounts greys;
        greys.counts[100] = 1;
        QCOMPARE(coverageOf(look, greys).mean, maskMean(look));
        QVERIFY(!coverageOf(look, greys).erodes);
        look.picture = Bitmap();
        QVERIFY(near(maskMean(look), 4.0 / 3.14159265, 1e-6));
    }

    void passesHaveTheColoursOfThePictureWhereTheyAreColours()
    {
        Effect effect = loneParticle(pictureOf(8, 8, [](int, int) { return Rgba{255, 0, 0, 255}; }));
        effect.look.colour = {0.5F, 0.5F, 0.5F};
        effect.light.shadow = 0.0F;
        effect.glow.emission = 2.0F;
        effect.glow.emissionCooling = 0.0F;
        effect.glow.emissionGradient = Gradient{{0.0F, glm::vec3(1.0F)}};
        PassRenderer renderer;
        PassImages images;
        const auto frame = frameOf(effect, 0);
        const SampledEffect whole = sampled(effect);
        const LayerAmongOthers layer{.effect = &whole, .now = frame.get()};
        QVERIFY(renderer
                    .render({.layers = {layer}}, 64, 64,
                        {Pass::Colour, Pass::Albedo, Pass::Emission, Pass::SixWayA, Pass::Temperature}, images)
                    .ok());
        for (const PassTarget target : {PassTarget::Albedo, PassTarget::Emission, PassTarget::Colour}) {
            const glm::vec4 pixel = images.of(target).at(32, 32);
            QVERIFY(pixel.r > 0.01F && pixel.g == 0.0F && pixel.b == 0.0F);
        }
        QVERIFY(images.of(PassTarget::RightTopBack).at(32, 32).g > 0.01F);
        QVERIFY(images.of(PassTarget::Inner).at(32, 32).g > 0.01F);
    }

    void layersSumUpToTheWholeToTheBit()
    {
        const Scene scene = leavesInSmoke();
        SceneRenderer simulation(scene);
        const SceneFrame frame = simulation.frame(9).value();
        Renderer renderer;
        Image whole;
        QVERIFY(renderer.render(LayersAtFrame(frame, simulation.layers()), 96, 80, whole).ok());
        std::vector<float> sum(whole.pixels.size(), 0.0F);
        LayerPictures pictures;
        QVERIFY(pictures
                    .contributions(renderer.layers(), whole, 1,
                        [&](std::size_t, const Image& share) {
                            for (std::size_t i = 0; i < sum.size(); ++i) {
                                sum[i] += share.pixels[i];
                            }
                        })
                    .ok());
        for (std::size_t i = 0; i < sum.size(); ++i) {
            QCOMPARE(sum[i], whole.pixels[i]);
        }
    }

    void theBitsAreTheSameForAnyThreadsAndInstructionSet()
    {
        const SimdGuard guard;
        const Scene scene = leavesInSmoke();
        const Image image = imageOf(scene);
        for (const int threads : {1, 2, 7}) {
            const ThreadLimit limit(threads);
            QVERIFY(sameBits(imageOf(scene).pixels, image.pixels));
        }
        for (const std::string& name : availableSimdTargets()) {
            QVERIFY(forceSimdTarget(name).ok());
            QVERIFY2(sameBits(imageOf(scene).pixels, image.pixels), name.c_str());
        }
    }
};

QTEST_GUILESS_MAIN(PicturedSpriteTest)
#include "pictured_sprite_test.moc"
