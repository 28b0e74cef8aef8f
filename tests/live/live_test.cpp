#include "tests/live/restless_minute.h"

#include "core/simulation/advance.h"

#include <random>
#include <set>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// A point that leaves particles standing where they are born.
Effect standing(int count)
{
    Effect effect = thesisEffect(count);
    effect.emitter.shape = EmitterShape::Disc;
    effect.emitter.radius = 0.0F;
    effect.emitter.subframe = true;
    effect.emitter.speed = 0.0F;
    effect.timeline.frameRate = 60;
    return effect;
}

} // namespace

class LiveTest : public QObject {
    Q_OBJECT

private slots:
    void whatNobodyChangesIsTheSimulatorToTheBit()
    {
        for (const EmissionMode mode : {EmissionMode::Continuous, EmissionMode::Burst}) {
            Effect effect = everythingOn();
            effect.emitter.mode = mode;
            effect.timeline.prewarm = false;
            const SimulationModel model(sampled(effect));
            LiveSimulation live = started(effect);
            int made = 0;
            for (const int step : {0, 1, 40, 200, 333}) {
                go(live, step + 1 - made);
                made = step + 1;
                Particles expected;
                QVERIFY(advanceFromNothing(model, expected, step).ok());
                QVERIFY(sameBits(live.particles(), expected));
            }
        }
    }

    void airThatStepsIsTheAirThatIsBakedToTheBit()
    {
        Effect effect = everythingOn();
        effect.air.enabled = true;
        effect.air.resolution = 16;
        effect.emitter.mode = EmissionMode::Burst; // its source ends
        effect.timeline.prewarm = false;
        Simulator simulator(sampled(effect));
        LiveSimulation live = started(effect);
        for (const int number : {0, 1, 2, 5, 30}) {
            go(live, number + 1 - static_cast<int>(live.frame().step + 1));
            QVERIFY(sameBits(live.particles(), simulator.frame(number).value()->particles));
        }
    }

    void anEffectThatIsSetAsItIsChangesNothing()
    {
        const Effect effect = windy(1500);
        LiveSimulation left = started(effect);
        LiveSimulation set = started(effect);
        for (int step = 0; step < 200; ++step) {
            QVERIFY(set.setEffect(effect).ok());
            go(left, 1);
            go(set, 1);
        }
        QVERIFY(sameBits(left.particles(), set.particles()));
    }

    void aMinuteOfChangesIsSmoothAndFlat()
    {
        const Effect effect = windy(3000);
        LiveSimulation live = started(effect);
        constexpr float kPeakOfSwirls = 6.0F; // times their root mean square
        std::size_t most = 0;
        endureAMinute(live, effect, kPeakOfSwirls * effect.turbulence.strength, 1e-5F, most);
        QVERIFY(most > 2000 && most <= live.particles().capacity);
    }

    void theSameMinuteHasTheSameBits()
    {
        const Effect effect = windy(1500);
        const auto run = [&] {
            LiveSimulation live = started(effect);
            RestlessGame game(effect);
            for (int step = 0; step < 900; ++step) {
                [&] { QVERIFY(game.act(live, step).ok()); }();
                go(live, 1);
            }
            return live.particles();
        };
        const Particles first = run();
        const ThreadLimit one(1);
        QVERIFY(sameBits(first, run()));
    }

    void smokeIsBornAlongTheWayOfTheEmitter()
    {
        LiveSimulation live = started(standing(60000));
        go(live, 1);
        QVERIFY(live.setEmitter({{3.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, glm::vec3(0.0F)}).ok());
        QCOMPARE(live.step(3.0 * live.stepSeconds()).value(), 3);
        const Particles& p = live.particles();
        std::array<int, 6> bins{};
        for (std::size_t i = 0; i < p.capacity; ++i) {
            if (p.birthStep[i] != Particles::kUnborn && p.birthStep[i] > 0) {
                const float age =
                    static_cast<float>(3 - p.birthStep[i]) + static_cast<float>(p.key[i] >> 8U) * 0x1p-24F;
                QVERIFY(near(p.x[i], 3.0F - age, 1e-5)); // a metre a step
                ++bins[static_cast<std::size_t>(std::min(5.0F, 2.0F * p.x[i]))];
            }
        }
        for (const int count : bins) {
            QVERIFY(near(count, 100.0, 40.0)); // 200 births a step, each half a metre has half of them
        }
    }

    void smokeIsThrownAlongTheNormalOnTheWay()
    {
        Effect effect = standing(6000);
        effect.emitter.speed = 2.0F;
        LiveSimulation live = started(effect);
        go(live, 1);
        QVERIFY(live.setEmitter({glm::vec3(0.0F), {5.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 7.0F}}).ok());
        go(live, 1);
        const Particles& p = live.particles();
        bool isBetween = false;
        for (std::size_t i = 0; i < p.capacity; ++i) {
            if (p.birthStep[i] == 1) {
                // From up to the right, in a straight line whose length is made 1; and the emitter's own velocity
                // beside.
                const float share = static_cast<float>(p.key[i] >> 8U) * 0x1p-24F;
                const glm::vec3 expected =
                    2.0F * glm::normalize(glm::vec3(1.0F - share, share, 0.0F)) + glm::vec3(0.0F, 0.0F, 7.0F);
                QVERIFY(glm::distance(expected, glm::vec3(p.vx[i], p.vy[i], p.vz[i])) < 1e-4F);
                isBetween = isBetween || (share > 0.3F && share < 0.7F);
            }
        }
        QVERIFY(isBetween);
    }

    void nothingIsBornWhereTheEmitterLeapsOver()
    {
        LiveSimulation live = started(standing(6000));
        go(live, 5);
        QVERIFY(live.placeEmitter({{100.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, glm::vec3(0.0F)}).ok());
        go(live, 5);
        const Particles& p = live.particles();
        for (std::size_t i = 0; i < p.capacity; ++i) {
            if (p.birthStep[i] != Particles::kUnborn) {
                QCOMPARE(p.x[i], p.birthStep[i] < 5 ? 0.0F : 100.0F);
            }
        }
    }

    void turbulenceStaysInTheWorld()
    {
        Effect effect = windy(2000);
        effect.turbulence.growth = 0.0F;
        LiveSimulation still = started(effect);
        LiveSimulation moved = started(effect);
        go(still, 60);
        go(moved, 60);
        still.setShare(0.0F);
        moved.setShare(0.0F);
        QVERIFY(moved.setEmitter({{4.0F, 1.0F, -2.0F}, {0.0F, 1.0F, 0.0F}, glm::vec3(0.0F)}).ok());
        go(still, 30);
        go(moved, 30);
        double farthest = 0.0;
        for (std::size_t i = 0; i < still.particles().capacity; ++i) {
            farthest =
                std::max(farthest, std::abs(static_cast<double>(still.particles().x[i] - moved.particles().x[i])));
        }
        QVERIFY(near(farthest, 0.0, 1e-3)); // rounding of places on the lattice, and what the swirls make of it
    }

    void sharesAndRatesAreKeptWhateverTheyChangeInto()
    {
        Schedule schedule = makeSchedule(sampled(thesisEffect(997)));
        BirthClock clock;
        double expected = 0.0;
        std::int64_t births = 0;
        std::mt19937 random{7};
        for (int step = 0; step < 5000; ++step) {
            schedule.birthsPerPeriod = 1 + static_cast<std::int64_t>(random() % 2000);
            schedule.windowSteps = schedule.periodSteps = 1 + static_cast<std::int64_t>(random() % 300);
            const float share = static_cast<float>(random() % 5) / 4.0F;
            expected += static_cast<double>(schedule.birthsPerPeriod) / static_cast<double>(schedule.windowSteps)
                * static_cast<double>(share);
            births += clock.next(schedule, share);
            QVERIFY(near(static_cast<double>(births), expected + 0.5, 0.51 + 1e-4 * step));
        }
    }

    void fewerPlacesThinTheBirthsEvenly_data()
    {
        QTest::addColumn<int>("places");
        for (const int places : {1, 7, 100, 499, 1000, 1999}) {
            QTest::newRow(std::to_string(places).c_str()) << places;
        }
    }
    void fewerPlacesThinTheBirthsEvenly()
    {
        QFETCH(int, places);
        const Effect effect = standing(2000);
        LiveSimulation live = started(effect, {.mostParticles = places});
        const std::int64_t life =
            live.sampledEffect()->emitter.count > 0 ? makeSchedule(live.sampledEffect()).lifetimeSteps : 0;
        const double rate = static_cast<double>(places) / static_cast<double>(life);
        double born = 0.0;
        for (std::int64_t step = 0; step < 3 * life; ++step) {
            go(live, 1);
            const std::span<const std::uint64_t> ids = live.ids();
            for (const std::uint64_t id : ids) {
                born = id == LiveSimulation::kNobody ? born : std::max(born, static_cast<double>(id) + 1.0);
            }
            // As many as a steady stream has given until now: no step is without where a rate has one for it, and none
            // has many.
            const double steady = rate * static_cast<double>(step + 1);
            QVERIFY2(std::abs(born - steady) <= 2.0 + 0.01 * steady + 3.0 * steady / places,
                qPrintable(QString("%1 instead of %2").arg(born).arg(steady)));
            QVERIFY(live.living() <= static_cast<std::size_t>(places));
        }
        QVERIFY(static_cast<double>(live.living()) >= 0.95 * places - 2.0);
    }

    void particlesKeepTheirNumberAndTheirAgeGrows()
    {
        LiveSimulation live = started(windy(500), {.mostParticles = 300});
        go(live, 30);
        const std::vector<std::uint64_t> before(live.ids().begin(), live.ids().end());
        const std::vector<float> young(live.ages().begin(), live.ages().end());
        go(live, 5);
        QCOMPARE(live.ids().size(), before.size());
        std::set<std::uint64_t> seen;
        for (std::size_t slot = 0; slot < before.size(); ++slot) {
            const std::uint64_t id = live.ids()[slot];
            const bool lives = live.particles().birthStep[slot] != Particles::kUnborn;
            QCOMPARE(id != LiveSimulation::kNobody, lives);
            QVERIFY(!lives || seen.insert(id).second);
            if (lives && id == before[slot]) {
                QVERIFY(near(static_cast<double>(live.ages()[slot] - young[slot]), 5.0 * kDt, 1e-5));
            }
            QVERIFY(lives || live.ages()[slot] == 0.0F);
        }
        QCOMPARE(seen.size(), live.living());
    }

    void aBurstComesOnceAndAgainWhenAsked()
    {
        Effect effect = standing(600);
        effect.emitter.mode = EmissionMode::Burst;
        effect.emitter.burstDuration = 0.1F;
        LiveSimulation live = started(effect, {.mostParticles = 5000});
        go(live, 30);
        QCOMPARE(live.living(), std::size_t(600));
        live.burst();
        go(live, 30);
        QCOMPARE(live.living(), std::size_t(1200));
    }

    void shorterLivesEndAtOnceAndPlacesBecomeFree()
    {
        Effect effect = standing(300); // of 5 s
        LiveSimulation live = started(effect);
        go(live, 300);
        QCOMPARE(live.living(), std::size_t(300));
        effect.life.fadeRate *= 5.0F; // 1 s
        QVERIFY(live.setEffect(effect).ok());
        go(live, 1);
        QVERIFY(live.living() <= 65);
        go(live, 120);
        QCOMPARE(live.living(), std::size_t(300));
    }

    void timeIsSavedUpIntoSteps()
    {
        LiveSimulation live = started(standing(60), {.mostStepsAtOnce = 4});
        QCOMPARE(live.step(0.4 * kDt).value(), 0);
        QCOMPARE(live.step(0.4 * kDt).value(), 0);
        QCOMPARE(live.step(0.4 * kDt).value(), 1);
        QVERIFY(near(live.saved(), 0.2 * kDt, 1e-9));
        for (int i = 0; i < 1000; ++i) {
            QCOMPARE(live.step(static_cast<double>(1.0F / 60.0F)).value(), 1);
        }
        QCOMPARE(live.step(10.0).value(), 4); // a game that has stood still
        QVERIFY(live.saved() < kDt);
    }

    void howeverLongATimeIsItIsLetGoAndTheNextStepIsAsEver_data()
    {
        QTest::addColumn<double>("seconds");
        for (const double seconds : {1e6, 1e9, 1e12, 1e15, 1e19, 1e300, 1e308, std::numeric_limits<double>::max()}) {
            QTest::newRow(qPrintable(QString::number(seconds))) << seconds;
        }
    }
    void howeverLongATimeIsItIsLetGoAndTheNextStepIsAsEver()
    {
        QFETCH(double, seconds);
        LiveSimulation live = started(windy(60), {.mostStepsAtOnce = 4});
        QVERIFY(live.setEmitter({{1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, {}}).ok());
        QCOMPARE(live.step(seconds).value(), 4);
        QVERIFY(live.saved() >= 0.0 && live.saved() <= kDt);
        QVERIFY(isFinite(live.particles()));
        for (int i = 0; i < 10; ++i) {
            const int steps = live.step(kDt).value();
            QVERIFY2(steps >= 0 && steps <= 2, qPrintable(QString::number(steps)));
        }
    }

    void aRendererTakesItsFrames()
    {
        Effect effect = everythingOn();
        effect.timeline.prewarm = false;
        LiveSimulation live = started(effect);
        go(live, 41);
        Renderer renderer;
        Image image;
        QVERIFY(
            renderer.render(live.frame(), live.sampledEffect(), effect.output.width, effect.output.height, image).ok());
        const Image expected = render(effect, 40);
        QCOMPARE(image.pixels.size(), expected.pixels.size());
        QVERIFY(std::memcmp(image.pixels.data(), expected.pixels.data(), image.pixels.size() * sizeof(image.pixels[0]))
            == 0);
        QCOMPARE(live.appearance().radius[0], renderer.appearance().radius[0]);
        QCOMPARE(live.colours()[0].a, renderer.appearance().alpha[0]);
    }

    void particlesBeginToRollWhileTheyLive()
    {
        Effect effect = windy(2000);
        effect.look.roll = 0.0F;
        LiveSimulation live = started(effect);
        go(live, 20);
        QVERIFY(!live.particles().rolls());
        const float x = live.particles().x[0];
        effect.look.roll = 1.0F;
        QVERIFY(live.setEffect(effect).ok());
        QVERIFY(live.particles().rolls());
        QCOMPARE(live.particles().x[0], x);
        go(live, 20);
        QVERIFY(live.particles().rollX[0] != 0.0F);
    }

    void whatCannotBeIsRefusedAndChangesNothing()
    {
        Effect effect = windy(100);
        LiveSimulation live = started(effect);
        go(live, 3);
        const float nan = std::numeric_limits<float>::quiet_NaN();
        QVERIFY(!live.step(-1.0));
        QVERIFY(!live.step(static_cast<double>(nan)));
        QVERIFY(!live.setEmitter({glm::vec3(nan), {0.0F, 1.0F, 0.0F}, glm::vec3(0.0F)}));
        QVERIFY(!live.setEmitter({glm::vec3(0.0F), glm::vec3(0.0F), glm::vec3(0.0F)}));
        Effect other = effect;
        other.timeline.frameRate = 30;
        QVERIFY(!live.setEffect(other));
        other = effect;
        other.air.enabled = true;
        QVERIFY(!live.setEffect(other));
        QCOMPARE(live.effect(), effect);
        QVERIFY(!LiveSimulation::start(effect, {.mostParticles = kMaxParticles + 1}));
        QVERIFY(!LiveSimulation::start(effect, {.stepsPerSecond = 241}));
        QVERIFY(!LiveSimulation::start(effect, {.budgetMs = -1.0}));
        QVERIFY(!LiveSimulation::start(effect, {.mostStepsAtOnce = 0}));
        go(live, 1);
    }
};

QTEST_GUILESS_MAIN(LiveTest)
#include "live_test.moc"
