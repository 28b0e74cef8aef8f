#include "tests/helpers.h"

#include "core/lighting/detail_field.h"
#include "core/lighting/detail_kernel.h"
#include "core/lighting/detail_light.h"

#include <glm/geometric.hpp>

using namespace fumage;
using namespace fumage::tests;

namespace {

float draw(std::uint32_t stream, int i)
{
    return unitFloat(keyOf(stream, static_cast<std::uint64_t>(i)));
}

/// Coordinates that nothing has moved yet, in a box of 4 m.
AdvectedCoordinates atRest()
{
    Effect effect = thesisEffect(10);
    effect.air.enabled = true;
    effect.air.resolution = 16;
    effect.air.size = glm::vec3(4.0F);
    effect.timeline.prewarm = false;
    AdvectedCoordinates out;
    if (!out.moveTo(frameOf(effect, 0)->model, 0, 1.0F, {})) {
        qFatal("no coordinates");
    }
    return out;
}

Effect detailed()
{
    Effect effect;
    effect.air.enabled = true;
    effect.look.detail = 1.0F;
    effect.look.detailSize = 0.5F;
    return effect;
}

LightGrid evenGrid(float density)
{
    LightGrid grid;
    grid.shape.nu = 40;
    grid.shape.nv = 30;
    grid.shape.nw = 20;
    grid.shape.cell = 0.05F;
    grid.density.assign(grid.shape.cells() + 64, density);
    return grid;
}

double meanOf(const AlignedArray<float>& values, std::size_t count)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        sum += static_cast<double>(values[i]);
    }
    return sum / static_cast<double>(count);
}

} // namespace

class DetailTest : public QObject {
    Q_OBJECT

private slots:
    void onlyDiscsInAirHaveDetail()
    {
        Effect effect = detailed();
        QVERIFY(hasDetail(effect));
        effect.look.mask = MaskShape::Square;
        QVERIFY(!hasDetail(effect));
        effect = detailed();
        effect.air.enabled = false;
        QVERIFY(!hasDetail(effect));
        effect = detailed();
        effect.look.detail = 0.0F;
        QVERIFY(!hasDetail(effect));
    }

    /// The weighted sum of two even noises is even again, whatever the weights.
    void blendedPhasesAreEven()
    {
        for (const float turn : {0.0F, 0.1F, 0.4F, 0.785398F, 1.2F, 1.5707F}) {
            const float a = std::cos(turn);
            const float b = std::sin(turn);
            const PhaseBlend blend(a, b);
            std::vector<float> values;
            for (int i = 0; i < 40000; ++i) {
                values.push_back(blend(a * (2.0F * draw(1, i) - 1.0F) + b * (2.0F * draw(2, i) - 1.0F)));
            }
            std::sort(values.begin(), values.end());
            for (const double share : {0.02, 0.2, 0.5, 0.8, 0.98}) {
                const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size()));
                QVERIFY(near(static_cast<double>(values[at]), 2.0 * share - 1.0, 0.04));
            }
        }
    }

    void finerOctavesGoFirst()
    {
        const AdvectedCoordinates coordinates = atRest();
        const DetailField field(detailed(), coordinates);
        const auto all = octaveSharesAt(field, {}, 1e-4F);
        const auto stretched = octaveSharesAt(
            field, {glm::vec3(0.0F), glm::mat3(glm::vec3(2, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 0.5F))}, 1e-4F);
        const auto afar = octaveSharesAt(field, {}, 0.05F);
        for (std::size_t i = 0; i < all.size(); ++i) {
            QCOMPARE(all[i], 1.0F);
            QVERIFY(stretched[i] < 1.0F && (i == 0 || stretched[i] < stretched[i - 1]));
            QVERIFY(i == 0 || afar[i] <= afar[i - 1]);
        }
        QCOMPARE(afar.back(), 0.0F); // a wave of 1/16 m on pixels of 1/20 m
        QVERIFY(afar.front() > 0.9F);
    }

    /// What folds take from the shadow, domes give back: the smoke as a whole is as dense as before.
    void detailKeepsTheMass()
    {
        const AdvectedCoordinates coordinates = atRest();
        Effect effect = detailed();
        for (const float shadow : {0.4F, 1.0F, 2.0F}) {
            effect.look.detailShadow = shadow;
            LightGrid grid = evenGrid(3.0F);
            putDetailIntoDensity(DetailField(effect, coordinates), grid);
            QVERIFY(near(meanOf(grid.density, grid.shape.cells()), 3.0, 0.25));
            QVERIFY(near(meanOf(grid.plain, grid.shape.cells()), 3.0, 1e-4));
            const auto end = grid.density.begin() + static_cast<std::ptrdiff_t>(grid.shape.cells());
            const auto [least, most] = std::minmax_element(grid.density.begin(), end);
            QVERIFY(*least >= 0.0F && *least < 2.4F && *most > 3.6F);
        }
        effect.look.detailShadow = 0.0F;
        LightGrid grid = evenGrid(3.0F);
        putDetailIntoDensity(DetailField(effect, coordinates), grid);
        QVERIFY(sameBits(grid.density, grid.plain));
    }

    /// A lone cell is a body for all within a wave along the axes, and for none other.
    void bodyReachesOneWave()
    {
        const AdvectedCoordinates coordinates = atRest();
        const DetailField field(detailed(), coordinates);
        LightGrid grid = evenGrid(0.0F);
        const auto index = [&](int u, int v, int w) {
            return static_cast<std::size_t>((w * grid.shape.nv + v) * grid.shape.nu + u);
        };
        grid.density[index(20, 15, 10)] = 4.0F;
        putDetailIntoDensity(field, grid);
        AlignedArray<float> body;
        findBody(field, grid, body);
        const double expected = 1.0 - std::exp(-0.4 * 4.0 * 0.5);
        QVERIFY(near(body[index(20, 15, 10)], expected, 1e-5));
        QVERIFY(near(body[index(10, 15, 10)], expected, 1e-5));
        QVERIFY(near(body[index(20, 15, 0)], expected, 1e-5));
        QCOMPARE(body[index(20, 15, 11)], 0.0F);
        QCOMPARE(body[index(0, 0, 0)], 0.0F);
    }
};

QTEST_APPLESS_MAIN(DetailTest)
#include "detail_test.moc"
