#include "tests/flow/flow_helpers.h"
#include "tests/helpers.h"

#include <vector>

using namespace fumage;
using namespace fumage::tests;

namespace {

const glm::ivec3 kCells{16, 20, 18};
constexpr float kHeight = 2.5F; // m, an eighth of one a cell
const glm::vec3 kWind{0.5F, 0.0F, -0.25F};

/// Velocity and heat of every cell.
std::vector<glm::vec4> cellsOf(const AirSolver& air)
{
    std::vector<glm::vec4> all;
    forCells(air.grid().cells, [&](const glm::ivec3& c) { all.push_back(air.at(c)); });
    return all;
}

std::size_t indexOf(const glm::ivec3& c, const glm::ivec3& n)
{
    return static_cast<std::size_t>(c.x + n.x * (c.y + n.y * c.z));
}

bool isWithin(const glm::ivec3& c, const glm::ivec3& n)
{
    return glm::all(glm::greaterThanEqual(c, glm::ivec3(0))) && glm::all(glm::lessThan(c, n));
}

/// Moves the box on by cells, boundaries and obstacles as they are said.
bool moveBy(
    AirSolver& air, const glm::ivec3& by, const AirBoundaries& boundaries = {}, std::span<const Solid> solids = {})
{
    return air.move(by, air.grid().corner + air.grid().cell * glm::vec3(by), boundaries, solids, kWind);
}

glm::vec4 ballOfHeat(const glm::vec3& place, const glm::vec3& wind)
{
    const glm::vec3 away = place - glm::vec3(0.0F, 0.8F, 0.0F);
    return {wind, std::exp(-10.0F * glm::dot(away, away))};
}

/// m
glm::vec3 centreOfHeat(const AirSolver& air)
{
    glm::vec3 sum(0.0F);
    float heat = 0.0F;
    forCells(air.grid().cells, [&](const glm::ivec3& c) {
        sum += air.at(c).w * air.grid().centre(c);
        heat += air.at(c).w;
    });
    return sum / heat;
}

/// Lets a plume rise in the middle of an open box.
void letRise(AirSolver& air)
{
    AirStep step = plumeStep(air.grid(), 0.4F);
    step.wind = kWind;
    for (int i = 0; i < 20; ++i) {
        air.step(step);
    }
}

} // namespace

/// The box of the air while it goes with an emitter.
class MovingBoxTest : public QObject {
    Q_OBJECT

private slots:
    void airStaysWhereItIsInTheWorldAndTheWindComesIn()
    {
        for (const glm::ivec3& by :
            {glm::ivec3(1, 0, 0), glm::ivec3(-2, 3, -1), glm::ivec3(0, -5, 17), glm::ivec3(40, 0, 0)}) {
            AirSolver air(boxOf(kCells, kHeight), {}, {}, kWind);
            letRise(air);
            const std::vector<glm::vec4> before = cellsOf(air);
            const glm::vec3 corner = air.grid().corner;
            QVERIFY(moveBy(air, by));
            QCOMPARE(air.grid().corner, corner + air.grid().cell * glm::vec3(by));
            forCells(kCells, [&](const glm::ivec3& c) {
                const glm::ivec3 then = c + by;
                QCOMPARE(air.at(c), isWithin(then, kCells) ? before[indexOf(then, kCells)] : glm::vec4(kWind, 0.0F));
            });
        }
    }

    void aBoxThatGoesWithTheWindIsOneThatStandsInStillAir()
    {
        // Seen from a car in a wind as fast as it, the air is at rest. In both a ball of heat rises as fast. The wind
        // is frozen while a step carries the air, so that a swirl is read where it was half a step before: that is a
        // drift of a hundredth of the way here.
        const AirGrid grid = boxOf({32, 28, 32}, kHeight);
        AirStep step = plainStep();
        step.buoyancy = 3.0F;
        AirStep blown = step;
        const glm::vec3 way(grid.cell, 0.0F, 0.0F);
        blown.wind = way / step.dt;
        AirSolver still(grid, {});
        AirSolver moved(grid, {}, {}, blown.wind);
        still.set([](const glm::vec3& place) { return ballOfHeat(place, glm::vec3(0.0F)); });
        moved.set([&](const glm::vec3& place) { return ballOfHeat(place, blown.wind); }, blown.wind);
        const glm::vec3 before = centreOfHeat(still);
        constexpr int kSteps = 30;
        for (int i = 0; i < kSteps; ++i) {
            still.step(step);
            QVERIFY(moved.move({1, 0, 0}, moved.grid().corner + way, {}, {}, blown.wind));
            moved.step(blown);
        }
        const glm::vec3 rise = (centreOfHeat(still) - before) / grid.cell;
        const glm::vec3 blownRise = (centreOfHeat(moved) - before) / grid.cell - glm::vec3(kSteps, 0.0F, 0.0F);
        QVERIFY(rise.y > 3.0F);
        QVERIFY2(glm::distance(rise, blownRise) < 0.15F, qPrintable(QString::number(glm::distance(rise, blownRise))));
    }

    void aMoveChangesNothingWhereTheBoxWasAndIs()
    {
        const AirGrid grid = boxOf({32, 28, 32}, kHeight);
        AirStep step = plainStep();
        step.buoyancy = 3.0F;
        AirSolver stays(grid, {});
        AirSolver goes(grid, {});
        for (AirSolver* air : {&stays, &goes}) {
            air->set([](const glm::vec3& place) { return ballOfHeat(place, glm::vec3(0.0F)); });
        }
        const glm::ivec3 by(3, -1, 2);
        for (int i = 0; i < 24; ++i) {
            if (i == 12) {
                QVERIFY(goes.move(by, grid.corner + grid.cell * glm::vec3(by), {}, {}, glm::vec3(0.0F)));
            }
            stays.step(step);
            goes.step(step);
        }
        double differences = 0.0;
        double squares = 0.0;
        forCells(grid.cells, [&](const glm::ivec3& c) {
            if (isWithin(c - by, grid.cells)) {
                const glm::vec4 difference = goes.at(c - by) - stays.at(c);
                differences += static_cast<double>(glm::dot(difference, difference));
                squares += static_cast<double>(glm::dot(stays.at(c), stays.at(c)));
            }
        });
        const double share = std::sqrt(differences / squares); // from boundaries that are elsewhere
        QVERIFY2(share < 0.05, qPrintable(QString::number(share)));
    }

    void obstaclesStayInTheWorld()
    {
        const AirGrid grid = boxOf(kCells, kHeight);
        const std::vector<Solid> solids{{SolidShape::Sphere, {0.25F, 1.25F, 0.0F}, glm::vec3(0.8F)}};
        AirSolver air(grid, {}, solids, kWind);
        letRise(air);
        int seen = 0;
        for (const glm::ivec3& by : {glm::ivec3(3, 2, -1), glm::ivec3(60, 0, 0), glm::ivec3(-62, -2, 0)}) {
            QVERIFY(moveBy(air, by, {}, solids));
            forCells(kCells, [&](const glm::ivec3& c) {
                QCOMPARE(air.isSolid(c), solids.front().contains(air.grid().centre(c)));
                seen += air.isSolid(c) ? 1 : 0;
            });
            AirStep step = plainStep();
            step.wind = kWind;
            for (int i = 0; i < 5; ++i) {
                air.step(step);
            }
            double divergence = 0.0;
            forCells(kCells, [&](const glm::ivec3& c) {
                divergence =
                    std::max(divergence, air.isSolid(c) ? 0.0 : std::abs(static_cast<double>(air.divergenceAt(c))));
            });
            QVERIFY2(divergence < 0.05, qPrintable(QString::number(divergence))); // 1/s
        }
        QVERIFY(seen > 200);
    }

    void aBoxThatAnObstacleWouldFillStaysWhereItIs()
    {
        const AirGrid grid = boxOf(kCells, kHeight);
        const std::vector<Solid> solids{{SolidShape::Box, {10.0F, 0.0F, 0.0F}, glm::vec3(12.0F)}};
        AirSolver air(grid, {}, solids, kWind);
        letRise(air);
        const std::vector<glm::vec4> before = cellsOf(air);
        QVERIFY(!moveBy(air, {80, 0, 0}, {}, solids));
        QCOMPARE(air.grid(), grid);
        QCOMPARE(cellsOf(air), before);
    }

    void aBoxThatLeavesTheGroundLetsAirInFromBelow()
    {
        const AirGrid grid = boxOf(kCells, kHeight);
        AirSolver air(grid, onGround());
        AirStep step = plumeStep(grid, 0.4F);
        step.source.place.y = 1.0F;
        step.source.last.y = kCells.y;
        const auto inflow = [&] {
            for (int i = 0; i < 30; ++i) {
                air.step(step);
            }
            AirField field(air.grid());
            air.read(field);
            return field.at(air.grid().corner + air.grid().size() * glm::vec3(0.5F, 0.0F, 0.5F)).y;
        };
        QCOMPARE(inflow(), 0.0F); // through the ground
        QVERIFY(moveBy(air, {0, 2, 0}));
        QVERIFY(inflow() > 0.05F);
        QVERIFY(moveBy(air, {0, -2, 0}, onGround()));
        QCOMPARE(inflow(), 0.0F);
    }
};

QTEST_GUILESS_MAIN(MovingBoxTest)
#include "moving_box_test.moc"
