#include "tests/live/restless_minute.h"

#include "core/simulation/air_plan.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

const glm::vec3 kUp{0.0F, 1.0F, 0.0F};

/// The mean of a number of those who live.
template <class Value>
double meanOf(const Particles& p, const Value& value)
{
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < p.capacity; ++i) {
        if (p.birthStep[i] != Particles::kUnborn) {
            sum += static_cast<double>(value(i));
            count += 1.0;
        }
    }
    return sum / count;
}

/// A model of an effect with its emitter somewhere.
SimulationModel modelAt(const Effect& effect, const AirGrid& grid, const glm::vec3& place)
{
    SimulationModel model(sampled(effect), grid);
    model.placeEmitter(place, kUp);
    return model;
}

} // namespace

/// Air that goes with a game's emitter.
class LiveAirTest : public QObject {
    Q_OBJECT

private slots:
    void anEmitterThatStaysWithinItsCellHasABoxThatStands()
    {
        const Effect effect = inAir(100);
        LiveAir air{SimulationModel(sampled(effect))};
        const AirGrid grid = air.grid();
        QCOMPARE(grid, airGrid(sampled(effect)));
        for (int step = 1; step < 30; ++step) {
            const float trembling = (step % 2 == 0 ? 0.7F : -0.7F) * grid.cell;
            air.step(modelAt(effect, grid, glm::vec3(trembling)), step, true);
            QCOMPARE(air.grid(), grid);
            QCOMPARE(air.field().grid, grid);
        }
    }

    void anEmitterNeverLeavesItsAir()
    {
        Effect effect = inAir(3000);
        effect.life.fadeRate = 0.1F; // a second
        LiveSimulation live = started(effect);
        for (int step = 0; step < 180; ++step) {
            const float way = 0.2F * static_cast<float>(step); // 12 m/s
            QVERIFY(live.setEmitter({{way, 0.05F * way, -way}, kUp, glm::vec3(0.0F)}).ok());
            go(live, 1);
        }
        const Particles& p = live.particles();
        QVERIFY(meanOf(p, [&](std::size_t i) { return p.heat[i]; }) > 0.05); // without air there is no heat
        std::size_t newborn = 0;
        for (std::size_t i = 0; i < p.capacity; ++i) {
            if (p.birthStep[i] >= 178) {
                QVERIFY2(p.heat[i] > 0.05F, qPrintable(QString::number(p.heat[i])));
                ++newborn;
            }
        }
        QVERIFY(newborn > 50);
    }

    void aWorldThatIsMovedByWholeCellsHasTheSameSmoke()
    {
        const auto run = [&](const glm::vec3& away) {
            Effect effect = inAir(2000);
            effect.air.obstacle = Obstacle::Sphere;
            effect.air.obstaclePosition = glm::vec3(1.0F, 2.0F, 0.0F) + away;
            effect.air.obstacleSize = glm::vec3(1.0F);
            effect.emitter.position = away;
            LiveSimulation live = started(effect);
            for (int step = 0; step < 60; ++step) {
                const glm::vec3 way(0.125F * static_cast<float>(step), 0.0625F * static_cast<float>(step), 0.0F);
                [&] { QVERIFY(live.setEmitter({way + away, kUp, glm::vec3(0.0F)}).ok()); }();
                go(live, 1);
            }
            return live.particles();
        };
        const glm::vec3 away(16.0F, -4.0F, 8.0F); // whole cells
        const Particles here = run(glm::vec3(0.0F));
        const Particles there = run(away);
        double worst = 0.0;
        for (std::size_t i = 0; i < here.capacity; ++i) {
            QCOMPARE(here.birthStep[i], there.birthStep[i]);
            if (here.birthStep[i] != Particles::kUnborn) {
                const glm::vec3 a(here.x[i], here.y[i], here.z[i]);
                const glm::vec3 b(there.x[i], there.y[i], there.z[i]);
                worst = std::max(worst, static_cast<double>(glm::distance(a, b - away)));
            }
        }
        QVERIFY2(worst < 1e-3, qPrintable(QString::number(worst)));
    }

    void aMinuteOfChangesIsSmoothAndFlat()
    {
        Effect effect = inAir(1500);
        effect.air.resolution = 16;
        LiveSimulation live = started(effect);
        std::size_t most = 0;
        endureAMinute(live, effect, 0.0F, 1e-4F, most);
        QVERIFY(live.living() > 500 && most <= live.particles().capacity);
    }

    void theBoxLeavesTheGroundAndComesBackToIt()
    {
        Effect effect = inAir(100);
        effect.air.ground = true;
        effect.air.groundHeight = -0.25F;
        LiveAir air{SimulationModel(sampled(effect))};
        const float floor = air.grid().corner.y;
        QCOMPARE(floor, -0.25F);
        const auto cornerAt = [&](int step, float height) {
            air.step(modelAt(effect, air.grid(), {0.0F, height, 0.0F}), step, true);
            return air.grid().corner.y;
        };
        QCOMPARE(cornerAt(1, 0.0F), floor);
        const float cell = air.grid().cell;
        const float above = cornerAt(2, 12.0F * cell);
        QVERIFY(near(above, floor + 12.0F * cell, 1e-5));
        QCOMPARE(cornerAt(3, 12.4F * cell), above);
        QCOMPARE(cornerAt(4, 0.0F), floor);
        QCOMPARE(cornerAt(5, -20.0F), floor);
    }

    void aBoxThatStartsHighAboveTheGroundComesDownToIt()
    {
        Effect effect = inAir(100);
        effect.air.ground = true;
        effect.air.groundHeight = -10.1F;
        LiveAir air{SimulationModel(sampled(effect))};
        QCOMPARE(air.grid().corner.y, 0.0F);
        air.step(modelAt(effect, air.grid(), {0.0F, -10.0F, 0.0F}), 1, true);
        QCOMPARE(air.grid().corner.y, -10.0F); // and not through it by a part of a cell
        AirField field = air.field();
        QCOMPARE(field.at({0.0F, -10.0F, 0.0F}).y, 0.0F);
    }

    void aWindThatIsSetMovesAllOfTheAir()
    {
        Effect effect = inAir(100);
        LiveAir air{SimulationModel(sampled(effect))};
        const glm::vec3 corner = air.grid().end() - 2.0F * air.grid().cell;
        air.step(modelAt(effect, air.grid(), glm::vec3(0.0F)), 1, true);
        QVERIFY(glm::length(glm::vec3(air.field().at(corner))) < 0.05F);
        effect.wind.strength = 3.0F; // over a drag of 1
        air.step(modelAt(effect, air.grid(), glm::vec3(0.0F)), 2, true);
        QCOMPARE(air.field().wind.x, 3.0F);
        QVERIFY(near(air.field().at(corner).x, 3.0, 0.1));
        effect.wind.strength = 0.0F;
        air.step(modelAt(effect, air.grid(), glm::vec3(0.0F)), 3, true);
        QVERIFY(glm::length(glm::vec3(air.field().at(corner))) < 0.1F);
    }
};

QTEST_GUILESS_MAIN(LiveAirTest)
#include "live_air_test.moc"
