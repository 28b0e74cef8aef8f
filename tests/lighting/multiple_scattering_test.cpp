// Light that smoke scatters many times, against closed forms of the diffusion equation.

#include "tests/helpers.h"
#include "tests/lighting/clouds.h"

#include "core/base/hash.h"
#include "core/base/parallel.h"
#include "core/lighting/appearance.h"
#include "core/lighting/light_grid.h"
#include "core/lighting/multiple_scattering.h"
#include "core/lighting/six_way.h"
#include "core/lighting/soft_light.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <glm/geometric.hpp>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr std::size_t kChannels = 4;
constexpr double kAbsorbed = 0.005;
constexpr double kPi64 = 3.14159265358979;

std::size_t cellAt(const GridShape& shape, const glm::ivec3& at)
{
    return static_cast<std::size_t>((at.z * shape.nv + at.y) * shape.nu + at.x);
}

/// Smoke of an extinction that differs from cell to cell, some of them clear, and light taken in all of it.
struct AnySmoke {
    AlignedArray<float> density;
    AlignedArray<float> taken;

    explicit AnySmoke(const GridShape& shape)
    {
        for (std::uint32_t i = 0; i < shape.cells(); ++i) {
            const float dense = unitFloat(streamBits(i, 1));
            density.push_back(dense < 0.3F ? 0.0F : 3.0F * dense);
            for (std::uint32_t channel = 0; channel < kChannels; ++channel) {
                taken.push_back(unitFloat(streamBits(i, 2 + channel)));
            }
        }
    }

    [[nodiscard]] AlignedArray<float> diffuse(const GridShape& shape) const
    {
        AlignedArray<float> light = taken;
        DiffusionWorkspace room;
        diffuseLight(shape, density, Float4{0.5F, 1.0F, 2.0F, 0.0F}, room, light);
        return light;
    }
};

/// A cube of white smoke of one metre, its sun above.
Effect whiteSmoke(float multiple)
{
    Effect effect = lookInSun();
    effect.light.resolution = 48;
    effect.look.opacity = 0.9F; // an optical depth of ten
    effect.light.multipleScattering = multiple;
    return effect;
}

constexpr glm::vec3 kEye(0.5F, 0.5F, 100.0F);

/// Its light, and what is next to it.
struct LitCube {
    Frame frame;
    Lit lit;

    explicit LitCube(const Effect& effect)
        : frame(cloud(effect, box(24)))
        , lit(frame, effect, kEye)
    {
    }

    /// A channel of the light with what is scattered many times, along the way of the sun through the middle.
    [[nodiscard]] std::vector<double> alongSun(std::size_t channel) const
    {
        std::vector<double> out;
        const LightGrid& grid = lit.grid;
        const GridShape& shape = grid.shape;
        for (int w = 1; w + 1 < shape.nw; ++w) {
            const std::size_t at = cellAt(shape, {shape.nu / 2, shape.nv / 2, w}) * kChannels + channel;
            out.push_back(static_cast<double>(grid.light[at])
                + (grid.diffuse.empty() ? 0.0 : static_cast<double>(grid.diffuse[at])));
        }
        return out;
    }
};

} // namespace

class MultipleScatteringTest : public QObject {
    Q_OBJECT

private slots:
    void lightOfAPointFallsAsTheEquationSays()
    {
        // phi = 3 s Q / (4 pi r) exp(-s sqrt(3 a) r), in even smoke that goes on.
        const GridShape shape = shapeOf(48, 48, 48);
        const glm::ivec3 middle(23);
        for (const double extinction : {0.6, 1.0, 1.5}) {
            const AlignedArray<float> density(shape.cells(), static_cast<float>(extinction));
            AlignedArray<float> light(shape.cells() * kChannels, 0.0F);
            light[cellAt(shape, middle) * kChannels] = 1.0F;
            DiffusionWorkspace room;
            diffuseLight(shape, density, Float4{1.0F, 0.0F, 0.0F, 0.0F}, room, light);
            for (const glm::ivec3 way : {glm::ivec3(3, 0, 0), glm::ivec3(0, -5, 0), glm::ivec3(0, 0, 8),
                     glm::ivec3(3, 3, 0), glm::ivec3(-4, 4, 4), glm::ivec3(0, 6, -6)}) {
                const double r = std::sqrt(static_cast<double>(way.x * way.x + way.y * way.y + way.z * way.z));
                const double expected =
                    3.0 * extinction / (4.0 * kPi64 * r) * std::exp(-extinction * std::sqrt(3.0 * kAbsorbed) * r);
                const double found = static_cast<double>(light[cellAt(shape, middle + way) * kChannels]);
                QVERIFY2(found > 0.7 * expected && found < 1.3 * expected,
                    qPrintable(QStringLiteral("%1 instead of %2, %3 m away").arg(found).arg(expected).arg(r)));
            }
        }
    }

    void inEvenLightWhiteSmokeCannotBeSeen()
    {
        // As much comes from all sides as goes to all sides: sky and ground with what is scattered are 2 everywhere.
        const LitCube cube(whiteSmoke(1.0F));
        const std::vector<double> sky = cube.alongSun(1);
        const std::vector<double> ground = cube.alongSun(2);
        for (std::size_t i = 0; i < sky.size(); ++i) {
            const double from = i < 3 || i + 3 >= sky.size() ? 1.1 : 1.5; // less at the edge: directions are but six
            QVERIFY2(
                sky[i] + ground[i] > from && sky[i] + ground[i] < 2.1, qPrintable(QString::number(sky[i] + ground[i])));
        }
        const LitCube once(whiteSmoke(0.0F));
        QVERIFY(once.alongSun(1)[sky.size() / 2] < 0.2); // where without it there is next to none
    }

    void aThickBodyInTheSunIsAsBrightAsPaper()
    {
        const std::vector<double> light = LitCube(whiteSmoke(1.0F)).alongSun(0);
        const std::vector<double> once = LitCube(whiteSmoke(0.0F)).alongSun(0);
        const double brightest = *std::max_element(light.begin(), light.end());
        QVERIFY2(brightest > 0.65 && brightest < 1.0, qPrintable(QString::number(brightest)));
        // A cube is as bright as paper but for what leaves it aside; deep in it light falls slowly.
        const std::size_t deep = light.size() / 2;
        QVERIFY2(light[deep] > 0.15 && once[deep] < 0.01,
            qPrintable(QStringLiteral("%1, once %2").arg(light[deep]).arg(once[deep])));
    }

    void withoutItNothingIsAdded()
    {
        const LitCube cube(whiteSmoke(0.0F));
        QVERIFY(cube.lit.grid.diffuse.empty());
        Effect clear = whiteSmoke(1.0F);
        clear.light.shadow = clear.light.occlusion = 0.0F;
        const LitCube nothingTaken(clear);
        for (const float light : nothingTaken.lit.grid.diffuse) {
            QCOMPARE(light, 0.0F);
        }
    }

    void lightsAddUp()
    {
        const GridShape shape = shapeOf(9, 8, 7);
        AnySmoke one(shape);
        AnySmoke both(shape);
        for (std::size_t i = 0; i < one.taken.size(); ++i) {
            both.taken[i] = 3.0F * one.taken[i];
        }
        const AlignedArray<float> a = one.diffuse(shape);
        const AlignedArray<float> b = both.diffuse(shape);
        for (std::size_t i = 0; i < a.size(); ++i) {
            QVERIFY(near(static_cast<double>(b[i]), 3.0 * static_cast<double>(a[i]), 1e-4 * static_cast<double>(b[i])));
        }
    }

    void gridsOfAnyShapeHaveFiniteLight_data()
    {
        QTest::addColumn<int>("nu");
        QTest::addColumn<int>("nv");
        QTest::addColumn<int>("nw");
        QTest::newRow("one cell") << 1 << 1 << 1;
        QTest::newRow("two cells") << 1 << 2 << 1;
        QTest::newRow("a line") << 1 << 1 << 13;
        QTest::newRow("odd") << 17 << 5 << 9;
        QTest::newRow("as long as can be") << kMaxLightResolution << 3 << 2;
    }

    void gridsOfAnyShapeHaveFiniteLight()
    {
        QFETCH(int, nu);
        QFETCH(int, nv);
        QFETCH(int, nw);
        const GridShape shape = shapeOf(nu, nv, nw);
        const AlignedArray<float> light = AnySmoke(shape).diffuse(shape);
        QCOMPARE(light.size(), shape.cells() * kChannels);
        for (const float each : light) {
            QVERIFY(std::isfinite(each) && each >= 0.0F);
        }
    }

    void theBitsDoNotDependOnThreads()
    {
        const GridShape shape = shapeOf(41, 30, 27);
        const AlignedArray<float> expected = AnySmoke(shape).diffuse(shape);
        for (const int threads : {1, 2, 7}) {
            const ThreadLimit limit(threads);
            const AlignedArray<float> out = AnySmoke(shape).diffuse(shape);
            QVERIFY(std::memcmp(out.data(), expected.data(), out.size() * sizeof(float)) == 0);
        }
    }

    void aDirectionOfSixIsASun()
    {
        // In the axes of the sun light along +w comes from -w.
        for (const float scattering : {0.0F, 0.5F}) {
            Effect effect = whiteSmoke(0.6F);
            effect.light.scattering = scattering;
            const LitCube sun(effect);
            const LitLayer layer{&sun.frame, &effect, &sun.lit.appearance, nullptr};
            SixWayLight six;
            LightWorkspace room;
            lightSixWays({&layer, 1}, lightAxes(effect.light.direction), kEye, room, six);
            LightGrid soft = sun.lit.grid;
            softenCells(soft.shape, kChannels, soft.light, room.soft);
            softenCells(soft.shape, kChannels, soft.diffuse, room.soft);
            for (std::size_t i = 0; i < soft.light.size(); i += kChannels) {
                const double expected = static_cast<double>(soft.light[i] + soft.diffuse[i]);
                QVERIFY(near(static_cast<double>(six.fromBelow[i + 2]), expected, 1e-3));
            }
        }
    }
};

QTEST_APPLESS_MAIN(MultipleScatteringTest)
#include "multiple_scattering_test.moc"
