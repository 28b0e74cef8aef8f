#include "tests/helpers.h"

#include "core/base/math.h"
#include "core/preset/library.h"
#include "core/rendering/scene_renderer.h"
#include "core/scene/scene.h"
#include "core/simulation/scene_simulator.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace fumage;
using namespace fumage::tests;

namespace {

SpriteTexture flatTexture(float grey)
{
    return SpriteTexture::pack(16, {AlignedArray<float>(256, grey)});
}

Sprite disc(float x, float y, float radius, float opacity, const glm::vec3& colour)
{
    Sprite s;
    s.x = x;
    s.y = y;
    s.halfWidth = s.halfHeight = radius;
    s.m00 = s.m11 = 1.0F / radius;
    s.opacity = opacity;
    s.ambient[0] = colour.r;
    s.ambient[1] = colour.g;
    s.ambient[2] = colour.b;
    s.texture = packTexture(0, TextureRef::kPlain, 0, 0, 0);
    return s;
}

SpriteBatch batchOf(int width, int height, const std::vector<std::pair<Sprite, std::uint32_t>>& sprites)
{
    SpriteBatch batch;
    batch.view.width = width;
    batch.view.height = height;
    for (const auto& [sprite, depth] : sprites) {
        batch.add(sprite, depth);
    }
    return batch;
}

Image compose(const SpriteBatch& batch, const SpriteTexture& texture)
{
    Compositor compositor;
    Image image;
    const SpriteLayer layer{&batch, &texture};
    if (!compositor.compose({&layer, 1}, image)) {
        qFatal("compose");
    }
    return image;
}

float profile(float r2)
{
    const float t = std::max(0.0F, 1.0F - r2);
    return t * t;
}

} // namespace

class RenderingTest : public QObject {
    Q_OBJECT

private slots:
    void aTextureReferenceSurvivesPacking()
    {
        for (const int slice : {0, 1, kMaxNoiseSlices - 1}) {
            for (const int level : {0, 5, TextureRef::kPlain}) {
                for (const std::uint32_t step : {0U, 1U, TextureRef::kErosionSteps}) {
                    const TextureRef ref = unpackTexture(packTexture(
                        static_cast<std::uint32_t>(slice), static_cast<std::uint32_t>(level), 200, 511, step));
                    QCOMPARE(ref.slice, slice);
                    QCOMPARE(ref.level, level);
                    QCOMPARE(ref.u, 200U);
                    QCOMPARE(ref.v, 255U); // of 511 the lower 8 bits: the tile repeats
                    QCOMPARE(ref.erosion, static_cast<float>(step) / 31.0F);
                }
            }
        }
    }

    void emptyPictureIsTransparent()
    {
        const Image image = compose(batchOf(70, 40, {}), flatTexture(1.0F));
        for (const float value : image.pixels) {
            QCOMPARE(value, 0.0F);
        }
    }

    void oneSpriteIsItsProfile()
    {
        const Image image =
            compose(batchOf(200, 100, {{disc(70.3F, 33.8F, 9.5F, 0.8F, {0.2F, 0.4F, 0.6F}), 5}}), flatTexture(1.0F));
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const float dx = static_cast<float>(x) + 0.5F - 70.3F;
                const float dy = static_cast<float>(y) + 0.5F - 33.8F;
                const float a = 0.8F * profile((dx * dx + dy * dy) / (9.5F * 9.5F));
                const glm::vec4 pixel = image.at(x, y);
                QVERIFY(std::abs(pixel.a - a) < 1e-5F);
                QVERIFY(std::abs(pixel.r - 0.2F * a) < 1e-5F && std::abs(pixel.b - 0.6F * a) < 1e-5F);
            }
        }
    }

    void edgesOfThePictureChangeNothingInside()
    {
        // Widths that fill tiles and patches, and widths that do not.
        const auto picture = [](int width, int height) {
            SpriteBatch batch = batchOf(width, height, {});
            for (std::uint32_t i = 0; i < 200; ++i) {
                const auto draw = [i](std::uint32_t stream) { return unitFloat(mixBits(i * 8 + stream)); };
                batch.add(
                    disc(140.0F * draw(0), 80.0F * draw(1), 1.0F + 20.0F * draw(2), 0.3F, {draw(3), draw(4), 0.5F}), i);
            }
            return compose(batch, flatTexture(1.0F));
        };
        const Image large = picture(256, 128);
        for (const auto& [width, height] : {std::pair{128, 64}, {127, 63}, {65, 90}, {3, 2}, {1, 1}, {130, 66}}) {
            const Image small = picture(width, height);
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    QVERIFY(small.at(x, y) == large.at(x, y));
                }
            }
        }
    }

    void nearerCoversFarther()
    {
        const Sprite red = disc(32.0F, 16.0F, 12.0F, 0.5F, {1.0F, 0.0F, 0.0F});
        const Sprite green = disc(32.0F, 16.0F, 12.0F, 0.5F, {0.0F, 1.0F, 0.0F});
        const Image redFirst = compose(batchOf(64, 32, {{red, 1}, {green, 2}}), flatTexture(1.0F));
        const Image greenFirst = compose(batchOf(64, 32, {{red, 2}, {green, 1}}), flatTexture(1.0F));
        const glm::vec4 a = redFirst.at(32, 16);
        const glm::vec4 b = greenFirst.at(32, 16);
        QVERIFY(a.r > 0.4F && std::abs(a.g - a.r * (1.0F - a.r)) < 1e-4F);
        QVERIFY(std::abs(a.r - b.g) < 1e-6F && std::abs(a.g - b.r) < 1e-6F);
        QVERIFY(std::abs(a.a - b.a) < 1e-6F);
    }

    void equalDepthsKeepTheirOrder()
    {
        const Sprite red = disc(32.0F, 16.0F, 12.0F, 0.5F, {1.0F, 0.0F, 0.0F});
        const Sprite green = disc(32.0F, 16.0F, 12.0F, 0.5F, {0.0F, 1.0F, 0.0F});
        const glm::vec4 pixel = compose(batchOf(64, 32, {{red, 7}, {green, 7}}), flatTexture(1.0F)).at(32, 16);
        QVERIFY(pixel.r > pixel.g);
    }

    void manySpritesEqualTheSumDoneByHand()
    {
        // Textured, rotated and plain ones of all sizes, over tile borders and picture edges, against a loop in double.
        std::vector<AlignedArray<float>> slices(3, AlignedArray<float>(64 * 64));
        for (std::size_t s = 0; s < slices.size(); ++s) {
            for (std::size_t i = 0; i < slices[s].size(); ++i) {
                slices[s][i] = unitFloat(mixBits(static_cast<std::uint32_t>(s * 10000 + i)));
            }
        }
        const SpriteTexture texture = SpriteTexture::pack(64, slices);
        SpriteBatch batch;
        batch.view.width = 150;
        batch.view.height = 90;
        batch.style.hardness = 1.3F;
        batch.style.texture = 0.7F;
        batch.style.erosionSoftness = 0.5F;
        batch.style.textureScale = 0.6F;
        batch.style.lightX = 0.5F;
        batch.style.lightY = -0.3F;
        batch.style.relief = 0.4F;
        batch.style.roundness = 0.3F;
        for (std::uint32_t i = 0; i < 300; ++i) {
            const auto random = [&](std::uint32_t stream) { return unitFloat(streamBits(mixBits(i), stream)); };
            const float radius = i % 3 == 0 ? 1.0F + 4.0F * random(0) : 5.0F + 40.0F * random(0);
            Sprite s = disc(150.0F * random(1), 90.0F * random(2), radius, 0.3F * random(3), {0.5F, 0.3F, 0.1F});
            s.m00 = s.m11 = std::cos(6.28F * random(4)) / radius;
            s.m01 = std::sin(6.28F * random(4)) / radius;
            s.m10 = -s.m01;
            s.direct[0] = s.direct[1] = s.direct[2] = 0.5F;
            if (i % 3 != 0) {
                s.texture = packTexture(i % 3, i % 5, i * 7U & 255U, i * 13U & 255U, i % 20);
            }
            batch.add(s, i); // already sorted
        }
        const Image image = compose(batch, texture);
        for (int y = 0; y < 90; y += 3) {
            for (int x = 0; x < 150; x += 1) {
                double through = 1.0;
                double red = 0.0;
                for (const Sprite& s : batch.sprites) {
                    const double dx = x + 0.5 - static_cast<double>(s.x);
                    const double dy = y + 0.5 - static_cast<double>(s.y);
                    const double p = static_cast<double>(s.m00) * dx + static_cast<double>(s.m01) * dy;
                    const double q = static_cast<double>(s.m10) * dx + static_cast<double>(s.m11) * dy;
                    const double inside = std::clamp(1.3F * (1.0 - p * p - q * q), 0.0, 1.0);
                    double a = inside * inside * static_cast<double>(s.opacity);
                    double shade = 1.0;
                    const TextureRef ref = unpackTexture(s.texture);
                    if (ref.level != TextureRef::kPlain && a > 0.0) {
                        const int edge = texture.levelSize(ref.level);
                        // The place between texels is known to 1/128, that of a row at dx = 0 as well, and the last
                        // step is the next texel.
                        const auto fixed = [&](float alongX, float alongY, double offset) {
                            const double row = std::round(
                                128.0 * (static_cast<double>(alongY) * dy * 0.3F * edge + offset / 256.0 * edge - 0.5));
                            return std::lround(128.0 * static_cast<double>(alongX) * dx * 0.3F * edge + row);
                        };
                        const long fixedU = fixed(s.m00, s.m01, ref.u);
                        const long fixedV = fixed(s.m10, s.m11, ref.v);
                        const int iu = static_cast<int>(fixedU >> 7) & (edge - 1);
                        const int iv = static_cast<int>(fixedV >> 7) & (edge - 1);
                        const std::uint32_t t = texture.texels(ref.level, ref.slice)[iv * edge + iu];
                        const auto byte = [&](unsigned shift) { return static_cast<double>(t >> shift & 255U); };
                        const double fu = static_cast<double>(fixedU & 127) / 127.0;
                        const double fv = static_cast<double>(fixedV & 127) / 127.0;
                        const double low = byte(0) + fu * (byte(8) - byte(0));
                        const double high = byte(16) + fu * (byte(24) - byte(16));
                        const double grey = low + fv * (high - low);
                        const double du = (byte(8) - byte(0)) + fv * ((byte(24) - byte(16)) - (byte(8) - byte(0)));
                        const double kept =
                            std::clamp((grey / 255.0 - static_cast<double>(ref.erosion)) / 0.5, 0.0, 1.0);
                        a *= 1.0 - 0.7F + 0.7F * kept;
                        const double scale = std::sqrt(std::abs(static_cast<double>(s.m00 * s.m11 - s.m01 * s.m10)));
                        const double lp =
                            (static_cast<double>(s.m00) * 0.5 + static_cast<double>(s.m01) * -0.3) / scale;
                        const double lq =
                            (static_cast<double>(s.m10) * 0.5 + static_cast<double>(s.m11) * -0.3) / scale;
                        const double relief = 0.4 * 0.3 * edge / 255.0;
                        shade = std::max(0.0, 1.0 + relief * (lp * du + lq * (high - low)) - 0.3 * (lp * p + lq * q));
                    }
                    red += through * a * (0.5 + 0.5 * shade);
                    through *= 1.0 - a;
                }
                const glm::vec4 pixel = image.at(x, y);
                QVERIFY2(std::abs(static_cast<double>(pixel.a) - (1.0 - through)) < 2e-3
                        && std::abs(static_cast<double>(pixel.r) - red) < 2e-3,
                    qPrintable(QString("%1,%2: %3 %4, expected %5 %6")
                                   .arg(x)
                                   .arg(y)
                                   .arg(pixel.a)
                                   .arg(pixel.r)
                                   .arg(1.0 - through)
                                   .arg(red)));
            }
        }
    }

    void squareMaskIsASquare()
    {
        Sprite s = disc(20.0F, 20.0F, 1.0F, 1.0F, {1.0F, 1.0F, 1.0F});
        s.m00 = s.m11 = 0.1F;
        s.halfWidth = s.halfHeight = 10.0F;
        s.texture = packTexture(0, 0, 0, 0, 0);
        SpriteBatch batch = batchOf(40, 40, {{s, 1}});
        batch.style.square = true;
        const Image image = compose(batch, flatTexture(1.0F));
        for (int y = 0; y < 40; ++y) {
            for (int x = 0; x < 40; ++x) {
                QCOMPARE(image.at(x, y).a, x >= 10 && x < 30 && y >= 10 && y < 30 ? 1.0F : 0.0F);
            }
        }
    }

    void squareEdgesAreAsLongAsTheyAreWhereverTheyLie()
    {
        constexpr float kHalf = 9.3F;
        for (const float degrees : {0.0F, 12.0F, 45.0F}) {
            for (const float offset : {0.0F, 0.25F, 0.6F}) {
                Sprite s = disc(20.0F + offset, 20.0F - offset, 1.0F, 1.0F, {1.0F, 1.0F, 1.0F});
                const float c = std::cos(radians(degrees)) / kHalf;
                const float d = std::sin(radians(degrees)) / kHalf;
                s.m00 = s.m11 = c;
                s.m01 = d;
                s.m10 = -d;
                s.halfWidth = s.halfHeight = 15.0F;
                s.texture = packTexture(0, 0, 0, 0, 0);
                SpriteBatch batch = batchOf(40, 40, {{s, 1}});
                batch.style.square = true;
                const Image image = compose(batch, flatTexture(1.0F));
                double area = 0.0;
                int between = 0;
                for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
                    const float alpha = image.pixels[i];
                    area += static_cast<double>(alpha);
                    between += alpha > 0.0F && alpha < 1.0F ? 1 : 0;
                }
                QVERIFY2(std::abs(area / (4.0 * 9.3 * 9.3) - 1.0) < 0.01,
                    qPrintable(QStringLiteral("%1 at %2 degrees").arg(area).arg(static_cast<double>(degrees))));
                QVERIFY(between > 30);
            }
        }
    }

    void depthSortIsStableAndSorted()
    {
        for (const std::size_t count : {0U, 1U, 50U, 95U, 96U, 5000U}) {
            std::vector<DepthEntry> entries;
            for (std::uint32_t i = 0; i < count; ++i) {
                entries.push_back(depthEntry(mixBits(i) >> 10U & 0x3fff00U, i));
            }
            std::vector<DepthEntry> expected = entries;
            std::stable_sort(
                expected.begin(), expected.end(), [](DepthEntry a, DepthEntry b) { return (a >> 32U) < (b >> 32U); });
            AlignedArray<DepthEntry> scratch;
            sortByDepth(entries, scratch);
            QVERIFY(entries == expected);
        }
    }

    void cameraPutsTheTargetInTheMiddle()
    {
        Camera camera;
        camera.target = {1.0F, 2.0F, 3.0F};
        for (const float yaw : {0.0F, 77.0F, -160.0F}) {
            for (const float pitch : {-60.0F, 0.0F, 89.0F}) {
                camera.yaw = yaw;
                camera.pitch = pitch;
                const Projected p = project(makeView(camera, 0.0F, 640, 360), camera.target);
                QVERIFY(std::abs(p.x - 320.0F) < 1e-2F && std::abs(p.y - 180.0F) < 1e-2F
                    && std::abs(p.depth - camera.distance) < 1e-4F);
            }
        }
    }

    void lensSeesItsAngle()
    {
        Camera camera;
        camera.mode = CameraMode::Fixed;
        camera.position = {0.0F, 0.0F, 9.0F};
        camera.view = {0.0F, 0.0F, -1.0F};
        camera.focalLength = 50.0F;
        // A 50 mm lens sees 36/50 of the distance across the shorter side.
        const View view = makeView(camera, 0.0F, 512, 512);
        const Projected right = project(view, {9.0F * 36.0F / 50.0F / 2.0F, 0.0F, 0.0F});
        QVERIFY(std::abs(right.x - 512.0F) < 1e-2F);
        const Projected up = project(view, {0.0F, 1.0F, 0.0F});
        QVERIFY(up.y < 256.0F);
        // A wider picture shows more at the sides and the same in height.
        const Projected top = project(makeView(camera, 0.0F, 1280, 512), {0.0F, 9.0F * 36.0F / 50.0F / 2.0F, 0.0F});
        QVERIFY(std::abs(top.y) < 1e-2F);
    }

    void turntableGoesAround()
    {
        Camera camera;
        camera.turntable = 90.0F;
        const View view = makeView(camera, 1.0F, 100, 100);
        QVERIFY(view.forward.x < -0.99F);
    }

    void supersamplingKeepsTheMeanLight()
    {
        Effect effect = everythingOn();
        effect.output.background = Background::Transparent;
        const auto sum = [&](int factor) {
            effect.output.supersample = factor;
            const Image image = render(effect, 5);
            double total = 0.0;
            for (const float value : image.pixels) {
                total += static_cast<double>(value);
            }
            return total;
        };
        const double one = sum(1);
        QVERIFY(one > 0.0);
        QVERIFY(std::abs(sum(3) / one - 1.0) < 0.02);
    }

    /// What it keeps from one picture to the next changes none: buffers, textures, coordinates, densities.
    void aRendererThatIsKeptGivesThePicturesOfANewOne()
    {
        Renderer kept;
        for (const char* name : {"default", "torch", "thesis-2012", "burning-logo"}) {
            Scene scene = loadPreset(std::string(name)).value().preset.scene;
            scene.output.quality = Quality::Draft;
            scene.air.resolution = 24;
            scene.light.resolution = 32;
            scene.timeline.prewarm = false;
            const std::vector<SampledEffect> layers = sampledLayers(scene);
            SceneSimulator simulator(layers);
            for (const int number : {12, 3, 20, 12}) {
                const SceneFrame frame = simulator.frame(number).value();
                const LayersAtFrame shown(frame, layers);
                Image later;
                Image first;
                QVERIFY(kept.render(shown, 96, 64, later).ok());
                QVERIFY(Renderer().render(shown, 96, 64, first).ok());
                QVERIFY2(later.pixels == first.pixels, name);
            }
        }
    }

    void hugePicturesAreRefusedBeforeAllocating()
    {
        Effect effect = everythingOn();
        effect.output.supersample = 4;
        Renderer renderer;
        Image image;
        const auto frame = frameOf(effect, 0);
        QCOMPARE(renderer.render(*frame, sampled(effect), 32768, 32768, image).error().code, ErrorCode::TooLarge);
    }

    void cameraInsideTheSmokeIsNoTrouble()
    {
        Effect effect = everythingOn();
        effect.camera.mode = CameraMode::Fixed;
        effect.camera.position = {0.0F, 0.5F, 0.0F};
        effect.camera.view = {0.0F, 1.0F, 0.0F};
        const Image image = render(effect, 20);
        for (const float value : image.pixels) {
            QVERIFY(std::isfinite(value));
        }
    }
};

QTEST_GUILESS_MAIN(RenderingTest)
#include "rendering_test.moc"
