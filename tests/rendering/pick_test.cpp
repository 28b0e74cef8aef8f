// Which layer is seen at a pixel.
#include "tests/helpers.h"

#include "core/rendering/pick.h"

#include <algorithm>

using namespace fumage;

namespace {

constexpr int kEdge = 64;

struct Disc {
    float x = 32.0F;
    float y = 32.0F;
    float radius = 8.0F;
    float opacity = 0.5F;
    float light = 0.5F;
    std::uint32_t depth = 1000;
};

/// Layers of discs.
struct Layers {
    std::vector<SpriteBatch> batches;
    SpriteTexture texture = SpriteTexture::pack(4, {AlignedArray<float>(16, 0.5F)});

    explicit Layers(const std::vector<std::vector<Disc>>& layers)
    {
        for (const std::vector<Disc>& discs : layers) {
            SpriteBatch& batch = batches.emplace_back();
            batch.view.width = kEdge;
            batch.view.height = kEdge;
            for (const Disc& disc : discs) {
                Sprite sprite;
                sprite.x = disc.x;
                sprite.y = disc.y;
                sprite.halfWidth = sprite.halfHeight = disc.radius;
                sprite.m00 = sprite.m11 = 1.0F / disc.radius;
                sprite.opacity = disc.opacity;
                std::fill_n(sprite.direct, 3, disc.light);
                sprite.texture = packTexture(0, TextureRef::kPlain, 0, 0, 0);
                batch.add(sprite, disc.depth);
            }
        }
    }
    [[nodiscard]] std::optional<std::size_t> at(int x, int y) const
    {
        std::vector<SpriteLayer> layers;
        for (const SpriteBatch& batch : batches) {
            layers.push_back({&batch, &texture});
        }
        return layerAt(layers, x, y);
    }
};

} // namespace

class PickTest : public QObject {
    Q_OBJECT

private slots:
    void eachIsFoundWhereItLies()
    {
        const Layers layers({{{.x = 12.0F}}, {{.x = 50.0F}}});
        QCOMPARE(layers.at(12, 32), std::optional<std::size_t>(0));
        QCOMPARE(layers.at(50, 32), std::optional<std::size_t>(1));
        QCOMPARE(layers.at(50, 4), std::nullopt);
        QCOMPARE(layers.at(31, 32), std::nullopt);
    }

    void whatLiesInFrontHidesWhatIsBehind()
    {
        const Disc near{.opacity = 0.9F, .depth = 10};
        const Disc far{.opacity = 0.9F, .depth = 5000};
        QCOMPARE(Layers({{near}, {far}}).at(32, 32), std::optional<std::size_t>(0));
        QCOMPARE(Layers({{far}, {near}}).at(32, 32), std::optional<std::size_t>(1));
    }

    /// Dark smoke before a flame: it is the flame that is seen.
    void whatShinesIsSeenThroughThinSmoke()
    {
        const Disc smoke{.opacity = 0.3F, .light = 0.02F, .depth = 10};
        const Disc flame{.opacity = 0.3F, .light = 5.0F, .depth = 5000};
        QCOMPARE(Layers({{smoke}, {flame}}).at(32, 32), std::optional<std::size_t>(1));
    }

    void manyThinOnesAreMoreThanOne()
    {
        const Disc one{.opacity = 0.2F, .depth = 10};
        std::vector<Disc> many;
        for (std::uint32_t i = 0; i < 20; ++i) {
            many.push_back({.opacity = 0.05F, .depth = 100 + i});
        }
        QCOMPARE(Layers({{one}, many}).at(32, 32), std::optional<std::size_t>(1));
    }

    void atTheEdgesThereIsNothingBeyond()
    {
        const Layers layers({{{.x = 0.0F, .y = 0.0F}}, {{.x = 63.0F, .y = 63.0F}}});
        QCOMPARE(layers.at(0, 0), std::optional<std::size_t>(0));
        QCOMPARE(layers.at(63, 63), std::optional<std::size_t>(1));
        QCOMPARE(layerAt({}, 3, 3), std::nullopt);
    }
};

QTEST_APPLESS_MAIN(PickTest)
#include "pick_test.moc"
