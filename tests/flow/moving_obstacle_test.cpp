// An obstacle that moves: what it does to the air.

#include "tests/flow/flow_helpers.h"

#include "core/base/parallel.h"
#include "core/base/simd.h"

#include <algorithm>
#include <cmath>

#include <QtTest/QtTest>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr float kDt = 1.0F / 30.0F;
constexpr float kSpeed = 0.9F;

Solid ballAt(int step)
{
    return {SolidShape::Sphere, {-0.5F + kSpeed * kDt * static_cast<float>(step), 1.0F, 0.0F}, glm::vec3(0.5F), {}, {}};
}

AirStep stepTo(int step)
{
    AirStep out = plainStep();
    out.obstacle = movedBetween(ballAt(step - 1), ballAt(step), kDt);
    return out;
}

AirSolver startedAir(const AirGrid& grid)
{
    const std::array solids{ballAt(0)};
    return AirSolver(grid, {}, solids);
}

/// Mean velocity of cells in a ball of air, m/s.
glm::dvec3 meanAround(const AirSolver& air, const glm::vec3& place, float radius)
{
    glm::dvec3 sum(0.0);
    double count = 0.0;
    forCells(air.grid().cells, [&](const glm::ivec3& c) {
        if (!air.isSolid(c) && glm::distance(air.grid().centre(c), place) < radius) {
            sum += glm::dvec3(air.at(c));
            count += 1.0;
        }
    });
    return sum / count;
}

bool isSame(const AirState& a, const AirState& b)
{
    return a.air == b.air && a.carrier == b.carrier && a.solids == b.solids;
}

/// Some steps of a plume that a ball goes through.
AirState smokyAir(AirField& field)
{
    const AirGrid grid = boxOf({37, 33, 29}, 2.0F);
    AirSolver air = startedAir(grid);
    field = AirField(grid);
    for (int i = 1; i <= 12; ++i) {
        AirStep step = plumeStep(grid, 0.3F);
        step.obstacle = stepTo(i).obstacle;
        step.obstacle->growth = glm::vec3(0.3F);
        step.friction = 0.1F;
        step.confinement = 0.2F;
        air.step(step, field);
    }
    return air.state();
}

} // namespace

class MovingObstacleTest : public QObject {
    Q_OBJECT

private slots:
    void aBallPushesTheAirBeforeItAndDrawsItAlongBehind_data()
    {
        QTest::addColumn<float>("sign");
        QTest::newRow("forwards") << 1.0F;
        QTest::newRow("backwards") << -1.0F;
    }
    void aBallPushesTheAirBeforeItAndDrawsItAlongBehind()
    {
        QFETCH(float, sign);
        AirSolver air = startedAir(boxOf({48, 32, 32}, 2.0F));
        constexpr int kSteps = 20;
        const auto ball = [&](int step) {
            Solid out = ballAt(step);
            out.centre.x *= sign;
            return out;
        };
        for (int i = 1; i <= kSteps; ++i) {
            AirStep step = plainStep();
            step.obstacle = movedBetween(ball(i - 1), ball(i), kDt);
            air.step(step);
        }
        const glm::vec3 centre = ball(kSteps).centre;
        const glm::vec3 ahead{sign * 0.3F, 0.0F, 0.0F};
        QVERIFY(
            static_cast<double>(sign) * meanAround(air, centre + ahead, 0.12F).x > 0.2 * static_cast<double>(kSpeed));
        QVERIFY(
            static_cast<double>(sign) * meanAround(air, centre - ahead, 0.12F).x > 0.2 * static_cast<double>(kSpeed));
        // Beside it the air comes back, as around a ball in a potential flow.
        QVERIFY(static_cast<double>(sign) * meanAround(air, centre + glm::vec3(0.0F, 0.33F, 0.0F), 0.06F).x < 0.0);
        // As much flows into each cell as out of it, through walls that move too.
        QVERIFY(shareOfDivergence(air, 0) < 0.02);
        forCells(air.grid().cells,
            [&](const glm::ivec3& c) { QCOMPARE(air.isSolid(c), ball(kSteps).contains(air.grid().centre(c))); });
    }

    void aBallThatGrowsBlowsAirOut()
    {
        const AirGrid grid = boxOf({32, 32, 32}, 2.0F);
        const auto ball = [](int step) {
            return Solid{
                SolidShape::Sphere, {0.0F, 1.0F, 0.0F}, glm::vec3(0.4F + 0.02F * static_cast<float>(step)), {}, {}};
        };
        const std::array solids{ball(0)};
        AirSolver air(grid, {}, solids);
        for (int i = 1; i <= 10; ++i) {
            AirStep step = plainStep();
            step.obstacle = movedBetween(ball(i - 1), ball(i), kDt);
            air.step(step);
        }
        for (const glm::vec3& out : {glm::vec3(1, 0, 0), glm::vec3(0, -1, 0), glm::vec3(0, 0, 1)}) {
            const glm::vec3 place = glm::vec3(0.0F, 1.0F, 0.0F) + 0.45F * out;
            QVERIFY(glm::dot(meanAround(air, place, 0.1F), glm::dvec3(out)) > 0.02);
        }
    }

    void oneThatStandsStillIsAsItAlwaysWas()
    {
        const AirGrid grid = boxOf({24, 32, 20}, 2.0F);
        const Solid ball{SolidShape::Sphere, {0.1F, 1.2F, 0.0F}, glm::vec3(0.5F), {}, {}};
        const std::array solids{ball};
        AirSolver plain(grid, onGround(), solids);
        AirSolver told(grid, onGround(), solids);
        AirStep step = plumeStep(grid, 0.3F);
        step.friction = 0.1F;
        for (int i = 0; i < 10; ++i) {
            step.obstacle.reset();
            plain.step(step);
            step.obstacle = ball;
            told.step(step);
        }
        QVERIFY(isSame(plain.state(), told.state()));
    }

    void oneThatIsPutElsewhereBlowsNothingAway()
    {
        AirSolver air = startedAir(boxOf({32, 32, 32}, 2.0F));
        AirStep step = plainStep();
        for (int i = 0; i < 5; ++i) {
            step.obstacle = ballAt(10 * i); // without a velocity
            air.step(step);
        }
        const AirState state = air.state();
        QVERIFY(std::all_of(state.air.begin(), state.air.end(), [](float number) { return number == 0.0F; }));
    }

    void oneThatFillsTheBoxStaysWhereItWas()
    {
        AirSolver air = startedAir(boxOf({16, 16, 16}, 2.0F));
        AirStep step = plainStep();
        step.obstacle = Solid{SolidShape::Box, {0.0F, 1.0F, 0.0F}, glm::vec3(50.0F), {}, {}};
        air.step(step);
        QVERIFY(air.state().solids.front() == ballAt(0));
    }

    void aStateThatIsRestoredGoesOnTheSame()
    {
        const AirGrid grid = boxOf({32, 24, 20}, 2.0F);
        AirSolver air = startedAir(grid);
        AirState kept;
        for (int i = 1; i <= 20; ++i) {
            air.step(stepTo(i));
            if (i == 8) {
                kept = air.state();
            }
        }
        const AirState expected = air.state();
        // Also where it has stood elsewhere meanwhile.
        AirSolver other = startedAir(grid);
        for (AirSolver* solver : {&air, &other}) {
            solver->restore(kept);
            for (int i = 9; i <= 20; ++i) {
                solver->step(stepTo(i));
            }
            QVERIFY(isSame(solver->state(), expected));
        }
    }

    void wallsFollowABodyToTheBit_data()
    {
        QTest::addColumn<SolidShape>("shape");
        QTest::addColumn<bool>("jumps");
        QTest::newRow("ball") << SolidShape::Sphere << false;
        QTest::newRow("box") << SolidShape::Box << false;
        QTest::newRow("box that jumps") << SolidShape::Box << true;
    }
    /// Only walls around the places before and after a step are placed anew: all of them would be the same. The body
    /// comes in from outside, grows and shrinks, and leaves.
    void wallsFollowABodyToTheBit()
    {
        QFETCH(SolidShape, shape);
        QFETCH(bool, jumps);
        const AirGrid grid = boxOf({33, 18, 27}, 2.0F);
        const auto body = [&](int step) {
            const auto at = static_cast<float>(jumps ? step * 7 % 24 : step);
            Solid out;
            out.shape = shape;
            out.centre = {-2.6F + 0.22F * at, 1.0F + 0.8F * std::sin(0.7F * at), 0.6F * std::cos(at)};
            out.size = glm::vec3(0.6F + 0.4F * std::sin(at));
            return out;
        };
        AirSolver air(grid, {}, {});
        bool hasStood = false;
        for (int i = 1; i <= 24; ++i) {
            AirStep step = plumeStep(grid, 0.3F);
            step.obstacle = movedBetween(body(i - 1), body(i), kDt);
            step.friction = 0.1F;
            const AirState before = air.state();
            AirSolver anew(grid, {}, before.solids);
            anew.restore(before);
            AirField field(grid);
            AirField fieldAnew(grid);
            air.step(step, field);
            anew.step(step, fieldAnew);
            QVERIFY2(isSame(air.state(), anew.state()), qPrintable(QString::number(i)));
            QVERIFY2(field.quads == fieldAnew.quads, qPrintable(QString::number(i)));
            bool stands = false;
            forCells(grid.cells, [&](const glm::ivec3& c) {
                QCOMPARE(air.isSolid(c), body(i).contains(grid.centre(c)));
                stands = stands || air.isSolid(c);
            });
            hasStood = hasStood || stands;
        }
        QVERIFY(hasStood);
    }

    void theBitsDependOnNeitherThreadsNorInstructionSets()
    {
        AirField first;
        const AirState expected = smokyAir(first);
        for (const std::string& target : availableSimdTargets()) {
            QVERIFY(forceSimdTarget(target).ok());
            for (const int threads : {1, 7}) {
                const ThreadLimit limit(threads);
                AirField field;
                QVERIFY2(isSame(smokyAir(field), expected), target.c_str());
                QVERIFY2(field.quads == first.quads, target.c_str());
            }
        }
        QVERIFY(forceSimdTarget("").ok());
    }
};

QTEST_APPLESS_MAIN(MovingObstacleTest)
#include "moving_obstacle_test.moc"
