#include "core/lighting/grid_cell-inl.h"

#include <cmath>

#include <QtTest/QtTest>

using namespace fumage;

namespace {

namespace hn = hwy::HWY_NAMESPACE;
namespace kernels = fumage::HWY_NAMESPACE;
using OneLane = hn::CappedTag<float, 1>;

struct Place {
    int corner = 0;
    glm::vec3 fraction{0.0F};
};

Place placeOf(const GridShape& shape, const glm::vec3& point)
{
    const OneLane d;
    const auto cell = kernels::gridCellAt(d, shape, kernels::broadcast(d, point));
    return {hn::GetLane(cell.corner),
        {hn::GetLane(cell.fraction.x), hn::GetLane(cell.fraction.y), hn::GetLane(cell.fraction.z)}};
}

/// Cells of half a metre, the axes swapped.
GridShape grid()
{
    GridShape shape;
    shape.axes = {glm::vec3(0.0F, 1.0F, 0.0F), glm::vec3(0.0F, 0.0F, 1.0F), glm::vec3(1.0F, 0.0F, 0.0F)};
    shape.origin = {1.0F, 2.0F, 3.0F};
    shape.cell = 0.5F;
    shape.nu = 4;
    shape.nv = 5;
    shape.nw = 6;
    return shape;
}

bool alike(const glm::vec3& a, const glm::vec3& b)
{
    return std::abs(a.x - b.x) < 1e-5F && std::abs(a.y - b.y) < 1e-5F && std::abs(a.z - b.z) < 1e-5F;
}

} // namespace

class GridCellTest : public QObject {
    Q_OBJECT

private slots:
    void cornerAndFractionSayWhereAPointIs()
    {
        // u = y = 1 + 0.5 * 1.25, v = z = 2 + 0.5 * 3.5, w = x = 3 + 0.5 * 2.75
        const Place place = placeOf(grid(), {4.375F, 1.625F, 3.75F});
        QCOMPARE(place.corner, (2 * 5 + 3) * 4 + 1);
        QVERIFY(alike(place.fraction, {0.25F, 0.5F, 0.75F}));
    }

    void pointsOutsideCountAsOnTheEdge()
    {
        const Place below = placeOf(grid(), glm::vec3(-1e9F));
        QCOMPARE(below.corner, 0);
        QCOMPARE(below.fraction, glm::vec3(0.0F));
        // The corner is never in the last layer, so that its neighbours are in the grid.
        const Place above = placeOf(grid(), glm::vec3(1e9F));
        QCOMPARE(above.corner, (4 * 5 + 3) * 4 + 2);
        QVERIFY(above.fraction.x > 0.99F && above.fraction.x < 1.0F);
        QVERIFY(above.fraction.y > 0.99F && above.fraction.y < 1.0F);
        QVERIFY(above.fraction.z > 0.99F && above.fraction.z < 1.0F);
    }

    void aGridOfOneCellHasOneCorner()
    {
        for (const float x : {-5.0F, 0.0F, 5.0F}) {
            const Place place = placeOf(GridShape{}, glm::vec3(x));
            QCOMPARE(place.corner, 0);
            QCOMPARE(place.fraction, glm::vec3(0.0F));
        }
    }
};

QTEST_GUILESS_MAIN(GridCellTest)
#include "grid_cell_test.moc"
