// Sprites with detail that the air carries, held against the formulas pixel by pixel.
#include "tests/helpers.h"

#include "core/rendering/compositor.h"

#include <algorithm>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kEdge = 64;
constexpr float kRadius = 24.0F;

struct Detailed {
    SpriteBatch batch;
    SpriteTexture texture = SpriteTexture::pack(4, {AlignedArray<float>(16, 0.5F)});

    [[nodiscard]] std::array<SpriteLayer, 1> layers() const { return {SpriteLayer{&batch, &texture}}; }
};

/// A disc with two phases of the detail.
Detailed oneSprite(bool first, bool second)
{
    Detailed out;
    SpriteBatch& batch = out.batch;
    batch.view.width = kEdge;
    batch.view.height = kEdge;
    Sprite sprite;
    sprite.x = 31.3F;
    sprite.y = 33.8F;
    sprite.halfWidth = sprite.halfHeight = kRadius;
    sprite.m00 = sprite.m11 = 1.0F / kRadius;
    sprite.opacity = 0.6F;
    std::copy_n(std::array{0.9F, 0.5F, 0.2F}.begin(), 3, sprite.direct);
    std::copy_n(std::array{0.05F, 0.1F, 0.2F}.begin(), 3, sprite.ambient);
    sprite.texture = packTexture(0, TextureRef::kPlain, 0, 0, 0);
    batch.add(sprite, 1000);
    SpriteDetail detail;
    const std::uint32_t one = LightBytes(0.3F, -0.2F, 0.9F).packed;
    const std::uint32_t other = LightBytes(-0.5F, 0.1F, 0.2F).packed;
    detail.phases[0] = {{3.7F, 120.2F, 60.9F}, {0.9F, 0.1F, -0.3F}, {0.2F, -0.8F, 0.4F}, one, 0.4F, 0.8F};
    detail.phases[1] = {{1.5F, 30.0F, 2.5F}, {-0.2F, 0.6F, 0.3F}, {0.5F, 0.1F, 0.7F}, other, 0.3F, 0.6F};
    detail.levels = {3, 1};
    detail.shown = {static_cast<std::uint8_t>(first ? 1 : 0), static_cast<std::uint8_t>(second ? 1 : 0)};
    detail.strength = 1.3F;
    detail.perMean = 0.9F;
    detail.gain = 1.25F;
    if (first && second) {
        detail.flat = 0.2F;
        detail.bend = 0.52F;
    }
    detail.screenRelief = 0.5F;
    detail.around = -0.4F;
    batch.details.push_back(detail);
    return out;
}

struct Texel {
    std::array<double, 4> numbers; ///< value and slopes, in units of DetailTexture::kFull
    std::array<double, 3> part; ///< way from its corner
};

Texel texelAt(const SpriteDetail& detail, std::size_t which, float dx, float dy)
{
    const SpriteDetail::Phase& phase = detail.phases[which];
    const int level = detail.levels[which];
    const int size = DetailTexture::size(level);
    Texel out{};
    std::array<std::size_t, 3> cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float at = phase.at[axis] + phase.u[axis] * dx + phase.v[axis] * dy;
        const double fixed = std::floor(at * 128.0F + 0.5F) / 128.0;
        out.part[axis] = fixed - std::floor(fixed);
        cell[axis] = static_cast<std::size_t>(static_cast<int>(std::floor(fixed)) & (size - 1));
    }
    const std::uint32_t texel = DetailTexture::instance().texel(level, cell[0], cell[1], cell[2]);
    for (std::size_t i = 0; i < 4; ++i) {
        out.numbers[i] = static_cast<std::int8_t>(texel >> 8U * i & 255U);
    }
    return out;
}

/// Premultiplied red, green, blue and alpha at a pixel.
std::array<double, 4> expectedAt(const Detailed& all, int x, int y)
{
    const Sprite& sprite = all.batch.sprites[0];
    const SpriteDetail& detail = all.batch.details[0];
    const float dx = static_cast<float>(x) + 0.5F - sprite.x;
    const float dy = static_cast<float>(y) + 0.5F - sprite.y;
    const double inside = std::clamp(1.0 - (dx * dx + dy * dy) / (kRadius * kRadius), 0.0, 1.0);
    double noise = 0.0;
    double slope = 0.0;
    for (std::size_t which = 0; which < 2; ++which) {
        if (detail.shown[which] == 0) {
            continue;
        }
        const Texel texel = texelAt(detail, which, dx, dy);
        double value = texel.numbers[0];
        double along = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            value += texel.numbers[axis + 1] * texel.part[axis] * 128.0 / 127.0;
            const auto byte = static_cast<std::int8_t>(detail.phases[which].light >> 8U * (axis + 1) & 255U);
            along += texel.numbers[axis + 1] * byte;
        }
        noise += static_cast<double>(detail.phases[which].weight) * value / 127.0;
        slope += static_cast<double>(detail.phases[which].relief) * along / 127.0;
    }
    const double beyond = std::max(0.0, std::abs(noise) - static_cast<double>(detail.flat));
    const double even =
        std::copysign(std::abs(noise) * 1.25 - beyond * beyond * static_cast<double>(detail.bend), noise);
    const double bent = 1.3 * even + 1.5;
    const double low = std::clamp(bent, 0.0, 1.0);
    const double factor = 0.5 * low * low + std::max(0.0, bent - 1.0);
    const double alpha = std::min(0.995, inside * inside * 0.6 * 0.9 * factor);
    const double shade = std::max(0.0, 1.0 + (1.25 - 2.0 * static_cast<double>(detail.bend) * beyond) * slope);
    std::array<double, 4> out{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double around = static_cast<double>(sprite.ambient[i]) * std::max(0.0, 1.0 - 0.4 * even);
        out[i] = alpha * (static_cast<double>(sprite.direct[i]) * shade + around);
    }
    out[3] = alpha;
    return out;
}

Image composed(const Detailed& all)
{
    Image image;
    Compositor compositor;
    if (!compositor.compose(all.layers(), image)) {
        qFatal("not composed");
    }
    return image;
}

} // namespace

class CoherentSpriteTest : public QObject {
    Q_OBJECT

private slots:
    void pixelsAreAsTheFormulasSay_data()
    {
        QTest::addColumn<bool>("first");
        QTest::addColumn<bool>("second");
        QTest::newRow("both phases") << true << true;
        QTest::newRow("first") << true << false;
        QTest::newRow("second") << false << true;
    }
    void pixelsAreAsTheFormulasSay()
    {
        QFETCH(bool, first);
        QFETCH(bool, second);
        const Detailed all = oneSprite(first, second);
        const Image image = composed(all);
        // Coordinates are rounded to 1/128 texel: at a texel's border a pixel may read the one beside.
        int beside = 0;
        for (int y = 0; y < kEdge; ++y) {
            for (int x = 0; x < kEdge; ++x) {
                const std::array<double, 4> expected = expectedAt(all, x, y);
                double worst = 0.0;
                for (std::size_t i = 0; i < 4; ++i) {
                    const auto value = static_cast<double>(image.row(y)[static_cast<std::size_t>(x) * 4 + i]);
                    worst = std::max(worst, std::abs(value - expected[i]));
                }
                beside += worst > 3e-3 ? 1 : 0;
            }
        }
        QVERIFY2(beside < kEdge * kEdge / 20, qPrintable(QString::number(beside)));
    }

    void withoutAnyPhaseASpriteIsPlain()
    {
        Detailed all = oneSprite(false, false);
        const Image image = composed(all);
        all.batch.details.clear();
        QVERIFY(sameBits(image.pixels, composed(all).pixels));
    }

    /// In light maps opposite lights are shaded by opposite slopes, and alpha is that of the colour.
    void lightsFromTheSidesShadeTheDetail()
    {
        const Detailed all = oneSprite(true, true);
        std::array<SpriteTarget, 3> targets;
        targets[0].light = TargetLight::Flat;
        targets[1].light = TargetLight::RightTopBack;
        targets[2].light = TargetLight::LeftBottomFront;
        std::array<Image, 3> images;
        std::vector<RenderTarget> wanted;
        for (std::size_t i = 0; i < 3; ++i) {
            targets[i].colours.assign(4, 1.0F);
            wanted.push_back({&targets[i], &images[i]});
        }
        Compositor compositor;
        QVERIFY(compositor.composeAll(all.layers(), wanted).ok());
        const Image colour = composed(all);
        double differ = 0.0;
        for (std::size_t i = 0; i < colour.pixels.size(); i += 4) {
            QCOMPARE(images[1].pixels[i + 3], colour.pixels[i + 3]);
            const float even = images[0].pixels[i];
            for (std::size_t channel = 0; channel < 2; ++channel) {
                const float one = images[1].pixels[i + channel];
                const float other = images[2].pixels[i + channel];
                if (one > 0.0F && other > 0.0F) {
                    QVERIFY(near(static_cast<double>(one + other), 2.0 * static_cast<double>(even), 1e-5));
                    differ += std::abs(static_cast<double>(one - other));
                }
            }
        }
        QVERIFY(differ > 1.0);
    }

    void everyInstructionSetGivesTheSameBits()
    {
        const SimdGuard guard;
        const Detailed all = oneSprite(true, true);
        const Image best = composed(all);
        for (const std::string& target : availableSimdTargets()) {
            QVERIFY(forceSimdTarget(target).ok());
            QVERIFY2(sameBits(composed(all).pixels, best.pixels), target.c_str());
        }
    }
};

QTEST_APPLESS_MAIN(CoherentSpriteTest)
#include "coherent_sprite_test.moc"
