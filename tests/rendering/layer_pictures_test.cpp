// What layers give to a picture: they add up to it, to the bit.
#include "tests/helpers.h"

#include "core/rendering/layer_pictures.h"
#include "core/rendering/scene_renderer.h"

#include <algorithm>
#include <numeric>
#include <random>

using namespace fumage;
using tests::sameBits;

namespace {

constexpr int kEdge = 40;

/// Layers of some smoke each, in one place and in front of one another, with or without detail, glow and texture.
Scene anyScene(unsigned seed, std::size_t layers, int supersample)
{
    std::mt19937 random(seed); // the same numbers everywhere
    const auto number = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random() & 0xffffU) / 65535.0F;
    };
    Scene scene;
    scene.layers.clear();
    Effect effect = tests::everythingOn();
    effect.air.enabled = false;
    effect.output.width = kEdge + static_cast<int>(seed % 3);
    effect.output.height = kEdge;
    effect.output.supersample = supersample;
    scene.setSurroundings(effect);
    for (std::size_t i = 0; i < layers; ++i) {
        effect.emitter.seed = static_cast<std::uint32_t>(random() & 0xffffU);
        effect.emitter.count = 100 + static_cast<int>(random() % 200);
        effect.emitter.position = {number(-1.0F, 1.0F), 0.0F, number(-1.0F, 1.0F)};
        effect.look.opacity = number(0.02F, 1.0F);
        effect.look.texture = i % 2 == 0 ? 0.9F : 0.0F;
        effect.look.colour = {number(0.0F, 1.0F), number(0.0F, 1.0F), number(0.0F, 1.0F)};
        effect.glow.emission = i % 3 == 0 ? 30.0F : 0.0F;
        scene.layers.emplace_back();
        scene.assign(i, effect);
    }
    return scene;
}

/// A picture with what its layers give to it.
struct Divided {
    Image whole;
    std::vector<Image> layers;
};

/// The sprites of a scene, ready to be painted.
class Prepared {
public:
    explicit Prepared(const Scene& scene)
        : m_scene(scene)
        , m_layers(sampledLayers(scene))
        , m_frame(SceneSimulator(m_layers).frame(8).value())
    {
        const Output& output = scene.output;
        const View view = makeView(scene.camera, secondsOf(scene.timeline, 8), output.width * output.supersample,
            output.height * output.supersample);
        if (!m_renderer.prepare(LayersAtFrame(m_frame, m_layers), view)) {
            qFatal("not prepared");
        }
    }

    [[nodiscard]] SpriteLayers layers() const { return m_renderer.layers(); }
    [[nodiscard]] Image paint(SpriteLayers layers) const
    {
        Image image;
        Compositor compositor;
        if (!compositor.compose(layers, image)) {
            qFatal("not painted");
        }
        return m_scene.output.supersample == 1 ? std::move(image) : downsample(image, m_scene.output.supersample);
    }
    [[nodiscard]] Divided divided() const
    {
        Divided out{paint(layers()), {}};
        LayerPictures pictures;
        const Status status = pictures.contributions(
            layers(), out.whole, m_scene.output.supersample, [&](std::size_t layer, const Image& picture) {
                QCOMPARE(layer, out.layers.size());
                out.layers.push_back(picture);
            });
        if (!status) {
            qFatal("not divided");
        }
        return out;
    }

private:
    Scene m_scene;
    std::vector<SampledEffect> m_layers;
    SceneFrame m_frame;
    Renderer m_renderer;
};

/// The sum of pictures in some order, in float.
Image sumOf(const std::vector<Image>& pictures, const std::vector<std::size_t>& order)
{
    Image sum = pictures.front();
    std::fill(sum.pixels.begin(), sum.pixels.end(), 0.0F);
    for (const std::size_t which : order) {
        for (std::size_t i = 0; i < sum.pixels.size(); ++i) {
            sum.pixels[i] += pictures[which].pixels[i];
        }
    }
    return sum;
}

/// Sprites that hide, and give no light.
SpriteBatch blackened(const SpriteBatch& batch)
{
    SpriteBatch black = batch;
    for (Sprite& sprite : black.sprites) {
        std::fill(std::begin(sprite.direct), std::end(sprite.direct), 0.0F);
        std::fill(std::begin(sprite.ambient), std::end(sprite.ambient), 0.0F);
    }
    return black;
}

} // namespace

class LayerPicturesTest : public QObject {
    Q_OBJECT

private slots:
    void contributionsAddUpToThePicture_data()
    {
        QTest::addColumn<unsigned>("seed");
        QTest::addColumn<int>("layers");
        QTest::addColumn<int>("supersample");
        unsigned seed = 1;
        for (const int layers : {1, 2, 3, 4, 5, 9, 14}) {
            for (const int supersample : {1, 2, 3}) {
                QTest::addRow("%d layers, %d x", layers, supersample) << seed++ << layers << supersample;
            }
        }
    }
    void contributionsAddUpToThePicture()
    {
        QFETCH(unsigned, seed);
        QFETCH(int, layers);
        QFETCH(int, supersample);
        const Prepared prepared(anyScene(seed, static_cast<std::size_t>(layers), supersample));
        const Divided divided = prepared.divided();
        QCOMPARE(divided.layers.size(), static_cast<std::size_t>(layers));
        QVERIFY(*std::ranges::max_element(divided.whole.pixels) > 0.0F);
        std::vector<std::size_t> order(divided.layers.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        QVERIFY(sameBits(sumOf(divided.layers, order).pixels, divided.whole.pixels));
        std::reverse(order.begin(), order.end());
        QVERIFY(sameBits(sumOf(divided.layers, order).pixels, divided.whole.pixels));
        std::shuffle(order.begin(), order.end(), std::mt19937(seed));
        QVERIFY(sameBits(sumOf(divided.layers, order).pixels, divided.whole.pixels));
        for (const Image& layer : divided.layers) {
            QVERIFY(std::ranges::all_of(layer.pixels, [](float value) { return value >= 0.0F; }));
        }
    }

    /// The others hide what they hide, and give nothing.
    void aContributionIsThePictureWithTheOthersBlack()
    {
        for (const int supersample : {1, 2}) {
            const Prepared prepared(anyScene(77, 6, supersample));
            const Divided divided = prepared.divided();
            const SpriteLayers all = prepared.layers();
            std::vector<SpriteBatch> black;
            for (const SpriteLayer& layer : all) {
                black.push_back(blackened(*layer.batch));
            }
            for (std::size_t k = 0; k < all.size(); ++k) {
                std::vector<SpriteLayer> others;
                for (std::size_t i = 0; i < all.size(); ++i) {
                    others.push_back({i == k ? all[i].batch : &black[i], all[i].texture});
                }
                const Image expected = prepared.paint(others);
                for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
                    const auto whole = static_cast<double>(divided.whole.pixels[i]);
                    if (i % 4 != 3) {
                        QVERIFY(tests::near(static_cast<double>(divided.layers[k].pixels[i]),
                            static_cast<double>(expected.pixels[i]), 1e-4 * whole));
                    }
                }
            }
        }
    }

    /// White that nothing lights shows how much of a layer is seen.
    void alphaIsWhatTheLayerCovers()
    {
        const Prepared prepared(anyScene(5, 3, 1));
        const Divided divided = prepared.divided();
        const SpriteLayers all = prepared.layers();
        for (std::size_t k = 0; k < all.size(); ++k) {
            std::vector<SpriteTarget> white(all.size());
            for (std::size_t i = 0; i < all.size(); ++i) {
                white[i].colours.assign(all[i].batch->sprites.size() * SpriteTarget::kStride, i == k ? 1.0F : 0.0F);
            }
            Image covered;
            const RenderTarget target{white.data(), &covered};
            Compositor compositor;
            QVERIFY(compositor.composeAll(all, {&target, 1}).ok());
            double most = 0.0;
            for (std::size_t i = 0; i < covered.pixels.size(); i += 4) {
                const auto alpha = static_cast<double>(divided.layers[k].pixels[i + 3]);
                QVERIFY(tests::near(alpha, static_cast<double>(covered.pixels[i]), 1e-5));
                most = std::max(most, alpha);
            }
            QVERIFY(most > 0.01);
        }
    }

    void ofOneLayerItIsThePicture()
    {
        const Prepared prepared(anyScene(3, 1, 2));
        const Divided divided = prepared.divided();
        QVERIFY(sameBits(divided.layers.front().pixels, divided.whole.pixels));
    }

    void aLayerThatIsNotSeenGivesNothing()
    {
        Scene scene = anyScene(11, 5, 1);
        scene.layers[2].look.opacity = 0.0F;
        const Divided divided = Prepared(scene).divided();
        QVERIFY(std::ranges::all_of(divided.layers[2].pixels, [](float value) { return value == 0.0F; }));
    }

    void everyInstructionSetGivesTheSameBits()
    {
        const tests::SimdGuard guard;
        const Prepared prepared(anyScene(21, 6, 1));
        const Divided best = prepared.divided();
        for (const std::string& target : availableSimdTargets()) {
            QVERIFY(forceSimdTarget(target).ok());
            const Divided here = prepared.divided();
            for (std::size_t k = 0; k < best.layers.size(); ++k) {
                QVERIFY2(sameBits(here.layers[k].pixels, best.layers[k].pixels), target.c_str());
            }
        }
    }

    void canBeStopped()
    {
        const Prepared prepared(anyScene(1, 3, 1));
        std::stop_source stop;
        stop.request_stop();
        LayerPictures pictures;
        const Status status = pictures.contributions(
            prepared.layers(), prepared.paint(prepared.layers()), 1, [](auto...) {}, stop.get_token());
        QVERIFY(!status.ok());
        QCOMPARE(status.error().code, ErrorCode::Cancelled);
    }
};

QTEST_APPLESS_MAIN(LayerPicturesTest)
#include "layer_pictures_test.moc"
