#include "tests/helpers.h"

#include "core/noise/detail_texture.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

/// Values of a level in the middle of its texels.
std::vector<float> valuesOf(int level)
{
    const auto size = DetailTexture::size(level);
    const auto at = [&](int i) { return (static_cast<float>(i) + 0.5F) / static_cast<float>(size); };
    std::vector<float> out;
    for (int z = 0; z < size; ++z) {
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                out.push_back(DetailTexture::instance().at(level, at(x), at(y), at(z)));
            }
        }
    }
    return out;
}

double correlation(int level, int finer)
{
    double both = 0.0;
    double one = 0.0;
    double other = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const auto draw = [&](std::uint32_t stream) { return unitFloat(keyOf(stream, static_cast<std::uint64_t>(i))); };
        const double a = DetailTexture::instance().at(level, draw(1), draw(2), draw(3));
        const double b = DetailTexture::instance().at(finer, draw(1), draw(2), draw(3));
        both += a * b;
        one += a * a;
        other += b * b;
    }
    return both / std::sqrt(one * other);
}

} // namespace

class DetailTextureTest : public QObject {
    Q_OBJECT

private slots:
    /// As many values below each number as if they were drawn evenly from -1 to 1.
    void theFinestLevelIsEven()
    {
        std::vector<float> values = valuesOf(DetailTexture::kLevels - 1);
        std::sort(values.begin(), values.end());
        for (const double share : {0.05, 0.25, 0.5, 0.75, 0.95}) {
            const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size()));
            QVERIFY(near(static_cast<double>(values[at]), 2.0 * share - 1.0, 0.03));
        }
    }

    void coarserLevelsAreTheSameNoiseWithLessInIt()
    {
        for (int level = 0; level + 1 < DetailTexture::kLevels; ++level) {
            QVERIFY(near(Moments::of(valuesOf(level)).mean, 0.0, 0.08));
            QVERIFY(correlation(level, level + 1) > 0.75);
        }
        QVERIFY(correlation(0, DetailTexture::kLevels - 1) > 0.6);
    }

    /// Values at a texel's border are nearly those of the next: what is stored as slopes is the noise's own.
    void texelsMeet()
    {
        const DetailTexture& texture = DetailTexture::instance();
        for (int level = 0; level < DetailTexture::kLevels; ++level) {
            const float texel = 1.0F / static_cast<float>(DetailTexture::size(level));
            double squares = 0.0;
            constexpr int kCount = 5000;
            for (int i = 0; i < kCount; ++i) {
                const auto index = static_cast<std::uint64_t>(i);
                const auto draw = [&](std::uint32_t stream) { return unitFloat(keyOf(stream, index)); };
                const float border = std::floor(draw(1) / texel) * texel;
                const double before = texture.at(level, border - 1e-4F * texel, draw(2), draw(3));
                const double after = texture.at(level, border + 1e-4F * texel, draw(2), draw(3));
                squares += (after - before) * (after - before);
            }
            QVERIFY(std::sqrt(squares / kCount) < 0.4 * std::pow(0.5, level)); // an octave more is half as strong
        }
    }

    /// Every texel has a place of its own, 16 neighbours one cache line, and rows are for those who know no bricks.
    void texelsLieInBricks()
    {
        for (int level = 0; level < 2; ++level) {
            const auto edge = static_cast<std::size_t>(DetailTexture::size(level));
            const DetailTexture& texture = DetailTexture::instance();
            const AlignedArray<std::uint32_t> rows = texture.texelsInRows(level);
            std::vector<bool> taken(edge * edge * edge, false);
            std::size_t i = 0;
            for (std::size_t z = 0; z < edge; ++z) {
                for (std::size_t y = 0; y < edge; ++y) {
                    for (std::size_t x = 0; x < edge; ++x, ++i) {
                        const std::size_t at = DetailTexture::indexOf(level, x, y, z);
                        QVERIFY(at < taken.size() && !taken[at]);
                        taken[at] = true;
                        QCOMPARE(at / 16, DetailTexture::indexOf(level, x & ~3U, y & ~1U, z & ~1U) / 16);
                        QCOMPARE(rows[i], texture.texels(level)[at]);
                    }
                }
            }
        }
    }

    void tilesRepeat()
    {
        const DetailTexture& texture = DetailTexture::instance();
        for (int level = 0; level < DetailTexture::kLevels; ++level) {
            QCOMPARE(texture.at(level, 0.375F, 0.625F, 0.125F), texture.at(level, -2.625F, 3.625F, 1.125F));
        }
    }
};

QTEST_APPLESS_MAIN(DetailTextureTest)
#include "detail_texture_test.moc"
