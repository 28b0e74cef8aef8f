// Light that is spread over neighbouring cells.

#include "tests/helpers.h"
#include "tests/lighting/clouds.h"

#include "core/base/hash.h"
#include "core/base/parallel.h"
#include "core/lighting/soft_light.h"

#include <cstring>

#include <QtTest/QtTest>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// Values of cells and channels, softened.
template <class ValueAt>
AlignedArray<float> softened(const GridShape& shape, std::size_t channels, const ValueAt& valueAt)
{
    AlignedArray<float> values;
    for (int w = 0; w < shape.nw; ++w) {
        for (int v = 0; v < shape.nv; ++v) {
            for (int u = 0; u < shape.nu; ++u) {
                for (std::size_t channel = 0; channel < channels; ++channel) {
                    values.push_back(valueAt(glm::ivec3(u, v, w), channel));
                }
            }
        }
    }
    AlignedArray<float> room;
    softenCells(shape, channels, values, room);
    return values;
}

/// Any numbers that are not alike.
float someNumber(const glm::ivec3& cell, std::size_t channel)
{
    return unitFloat(streamBits(
        static_cast<std::uint32_t>(cell.x + 100 * cell.y + 10000 * cell.z), static_cast<std::uint32_t>(channel)));
}

} // namespace

class SoftLightTest : public QObject {
    Q_OBJECT

private slots:
    void evenLightStaysAsItIsToTheBit_data()
    {
        QTest::addColumn<int>("nu");
        QTest::addColumn<int>("nv");
        QTest::addColumn<int>("nw");
        QTest::newRow("a box") << 9 << 7 << 5;
        QTest::newRow("one cell") << 1 << 1 << 1;
        QTest::newRow("two cells") << 2 << 1 << 1;
        QTest::newRow("a line") << 1 << 1 << 12;
        QTest::newRow("a plane") << 17 << 1 << 3;
        QTest::newRow("as long as can be") << kMaxLightResolution << 2 << 1;
    }

    void evenLightStaysAsItIsToTheBit()
    {
        QFETCH(int, nu);
        QFETCH(int, nv);
        QFETCH(int, nw);
        const AlignedArray<float> out = softened(shapeOf(nu, nv, nw), 4,
            [](const glm::ivec3& /*cell*/, std::size_t channel) { return 0.1F + 0.3F * static_cast<float>(channel); });
        for (std::size_t i = 0; i < out.size(); ++i) {
            QCOMPARE(out[i], 0.1F + 0.3F * static_cast<float>(i % 4));
        }
    }

    void aCellGoesToItsNeighboursByTheWeightsAndNothingIsLost()
    {
        const GridShape shape = shapeOf(7, 6, 5);
        const glm::ivec3 middle(3, 2, 2);
        const AlignedArray<float> out = softened(shape, 2, [&](const glm::ivec3& cell, std::size_t channel) {
            return cell == middle ? 64.0F * static_cast<float>(channel) : 0.0F;
        });
        const auto weight = [](int way) { return way == 0 ? 2.0F : way == 1 || way == -1 ? 1.0F : 0.0F; };
        float sum = 0.0F;
        std::size_t i = 0;
        for (int w = 0; w < shape.nw; ++w) {
            for (int v = 0; v < shape.nv; ++v) {
                for (int u = 0; u < shape.nu; ++u, i += 2) {
                    const glm::ivec3 way = glm::ivec3(u, v, w) - middle;
                    QCOMPARE(out[i], 0.0F);
                    QCOMPARE(out[i + 1], weight(way.x) * weight(way.y) * weight(way.z));
                    sum += out[i + 1];
                }
            }
        }
        QCOMPARE(sum, 64.0F);
    }

    void largerCellsSpreadLightAsFarAsSmallOnes()
    {
        // The mean square distance that light of one cell is spread, m^2: half a finest cell's square along each axis.
        for (const float cell : {0.1F, 0.15F, 0.3F}) {
            GridShape shape = shapeOf(5, 5, 5);
            shape.finest = 0.1F;
            shape.cell = cell;
            const glm::ivec3 middle(2);
            const AlignedArray<float> out = softened(
                shape, 1, [&](const glm::ivec3& at, std::size_t /*channel*/) { return at == middle ? 1.0F : 0.0F; });
            double spread = 0.0;
            for (int i = 0; i < 125; ++i) {
                const int away = i % 5 - 2;
                spread += static_cast<double>(out[static_cast<std::size_t>(i)]) * away * away
                    * static_cast<double>(cell * cell);
            }
            QVERIFY(near(spread, 0.5 * 0.1 * 0.1, 1e-7));
        }
    }

    void lightThatFallsEvenlyStaysSo()
    {
        const GridShape shape = shapeOf(8, 9, 6);
        const auto slope = [](const glm::ivec3& cell, std::size_t /*channel*/) {
            return static_cast<float>(2 * cell.x - 3 * cell.y + cell.z);
        };
        const AlignedArray<float> out = softened(shape, 1, slope);
        for (int w = 1; w + 1 < shape.nw; ++w) {
            for (int v = 1; v + 1 < shape.nv; ++v) {
                for (int u = 1; u + 1 < shape.nu; ++u) {
                    QCOMPARE(out[static_cast<std::size_t>((w * shape.nv + v) * shape.nu + u)], slope({u, v, w}, 0));
                }
            }
        }
    }

    void theBitsDoNotDependOnThreads()
    {
        const GridShape shape = shapeOf(33, 21, 19);
        const AlignedArray<float> expected = softened(shape, 4, someNumber);
        for (const int threads : {1, 2, 7}) {
            const ThreadLimit limit(threads);
            const AlignedArray<float> out = softened(shape, 4, someNumber);
            QVERIFY(std::memcmp(out.data(), expected.data(), out.size() * sizeof(float)) == 0);
        }
    }
};

QTEST_APPLESS_MAIN(SoftLightTest)
#include "soft_light_test.moc"
