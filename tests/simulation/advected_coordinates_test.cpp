#include "tests/helpers.h"

#include "core/simulation/advected_coordinates.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr float kLife = 0.4F;

Effect smokeInAir(bool loop)
{
    Effect effect = thesisEffect(100);
    effect.air.enabled = true;
    effect.air.resolution = 16;
    effect.air.size = {2.0F, 3.0F, 2.0F};
    effect.timeline.loop = loop;
    effect.timeline.length = 50;
    effect.life.fadeRate = 1.0F;
    return effect;
}

std::shared_ptr<const SimulationModel> modelOf(const Effect& effect)
{
    return frameOf(effect, 0)->model;
}

AdvectedCoordinates at(const std::shared_ptr<const SimulationModel>& model, std::int64_t step)
{
    AdvectedCoordinates out;
    if (!out.moveTo(model, step, kLife, {})) {
        qFatal("no coordinates");
    }
    return out;
}

bool isSame(const AdvectedCoordinates& a, const AdvectedCoordinates& b)
{
    for (std::size_t i = 0; i < 2; ++i) {
        const AdvectedPhase& x = a.phases()[i];
        const AdvectedPhase& y = b.phases()[i];
        if (!sameBits(x.map.quads, y.map.quads) || x.seed != y.seed || x.age != y.age || x.weight != y.weight) {
            return false;
        }
    }
    return true;
}

} // namespace

class AdvectedCoordinatesTest : public QObject {
    Q_OBJECT

private slots:
    void seedsFollowOneAnother_data()
    {
        QTest::addColumn<bool>("loop");
        QTest::newRow("endless") << false;
        QTest::newRow("loop") << true;
    }
    void seedsFollowOneAnother()
    {
        QFETCH(bool, loop);
        const Schedule schedule = modelOf(smokeInAir(loop))->schedule();
        for (const float life : {0.01F, 0.2F, kLife, 3.0F}) {
            const SeedTimes times(schedule, life);
            for (std::int64_t step = -70; step < 170; ++step) {
                const std::int64_t seed = times.seedAt(step);
                QVERIFY(times.stepOf(seed) <= step && step < times.stepOf(seed + 1));
                if (loop) {
                    const std::int64_t later = times.seedAt(step + schedule.loopSteps);
                    QCOMPARE(times.randomNumber(later), times.randomNumber(seed));
                    QCOMPARE((later - seed) % 2, 0); // so that both maps take turns in every loop
                    QCOMPARE(times.stepOf(later), times.stepOf(seed) + schedule.loopSteps);
                }
            }
        }
    }

    /// Contrast does not pulse: the squares of the weights sum to 1, and no map is seen when it is seeded.
    void weightsKeepTheContrast()
    {
        const auto model = modelOf(smokeInAir(false));
        AdvectedCoordinates coordinates;
        for (std::int64_t step = 0; step < 40; ++step) {
            QVERIFY(coordinates.moveTo(model, step, kLife, {}));
            double squares = 0.0;
            for (const AdvectedPhase& phase : coordinates.phases()) {
                squares += static_cast<double>(phase.weight) * static_cast<double>(phase.weight);
                QVERIFY(phase.age > 0 || phase.weight == 0.0F);
            }
            QVERIFY(near(squares, 1.0, 1e-6));
        }
    }

    void anyStepAloneHasTheSameBits_data() { seedsFollowOneAnother_data(); }
    void anyStepAloneHasTheSameBits()
    {
        QFETCH(bool, loop);
        const auto model = modelOf(smokeInAir(loop));
        const std::int64_t start = model->schedule().firstStep;
        AdvectedCoordinates moving;
        for (const std::int64_t step : {0, 1, 2, 7, 8, 9, 30, 31, 12, 13, 49, 0, 1}) {
            QVERIFY(moving.moveTo(model, start + step, kLife, {}));
            QVERIFY(isSame(moving, at(model, start + step)));
        }
    }

    void loopsMeetThemselves()
    {
        const auto model = modelOf(smokeInAir(true));
        const Schedule& schedule = model->schedule();
        for (const std::int64_t step : {0, 5, 49}) {
            QVERIFY(isSame(
                at(model, schedule.firstStep + step), at(model, schedule.firstStep + step + schedule.loopSteps)));
        }
    }

    void anotherAirOrLifeBeginsAnew()
    {
        Effect windy = smokeInAir(false);
        windy.wind.strength = 5.0F;
        const auto calm = modelOf(smokeInAir(false));
        const auto other = modelOf(windy);
        AdvectedCoordinates coordinates;
        QVERIFY(coordinates.moveTo(calm, 10, kLife, {}));
        QVERIFY(coordinates.moveTo(other, 11, kLife, {}));
        QVERIFY(isSame(coordinates, at(other, 11)));
        QVERIFY(coordinates.moveTo(other, 11, 0.9F, {}));
        QVERIFY(!isSame(coordinates, at(other, 11)));
    }

    /// What was cancelled is not taken for done.
    void cancelledMapsAreMadeAgain()
    {
        const auto model = modelOf(smokeInAir(false));
        (void)model->air()->bake(30);
        AdvectedCoordinates coordinates;
        QVERIFY(coordinates.moveTo(model, 8, kLife, {}));
        std::stop_source stop;
        stop.request_stop();
        const auto fresh = modelOf(smokeInAir(false)); // whose air is not baked
        QVERIFY(!coordinates.moveTo(fresh, 20, kLife, stop.get_token()));
        QVERIFY(coordinates.moveTo(fresh, 20, kLife, {}));
        QVERIFY(isSame(coordinates, at(fresh, 20)));
    }
};

QTEST_APPLESS_MAIN(AdvectedCoordinatesTest)
#include "advected_coordinates_test.moc"
