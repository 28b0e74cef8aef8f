// Key frames of a scene play inside a game.

#include "tests/helpers.h"

#include "core/effect/known_parameter.h"
#include "core/live/live_scene.h"
#include "core/scene/key_assignment.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

/// Points that stay where they are born.
Scene dots(int count)
{
    Effect effect = thesisEffect(count);
    effect.emitter.width = 0.0F;
    effect.emitter.depth = 0.0F;
    effect.emitter.speed = 0.0F;
    effect.emitter.subframe = true;
    return effect;
}

Scene animated(Scene scene, const char* keys)
{
    const Result<bool> clamped = animateScene(scene, keys);
    if (!clamped) {
        qFatal("%s", clamped.error().text().c_str());
    }
    return scene;
}

/// A sphere that goes through still air for .4 s and stands then, among particles that this air carries.
Scene besideAnObstacle(const char* keys = "0:-0.2,1,0:linear; 0.4:0.2,1,0")
{
    Effect effect = dots(2000).effect();
    effect.emitter.width = 2.0F;
    effect.emitter.depth = 2.0F;
    effect.emitter.position = {0.0F, 1.0F, 0.0F};
    effect.motion.buoyancy = 0.0F;
    effect.air.enabled = true;
    effect.air.resolution = kMinAirResolution;
    effect.air.obstacle = Obstacle::Sphere;
    effect.air.obstacleSize = glm::vec3(0.6F);
    effect.air.obstaclePosition = {-0.2F, 1.0F, 0.0F};
    return animated(effect, ("air.obstacle_position=" + std::string(keys)).c_str());
}

/// How far apart a particle is that lives in both, m.
double farthestApart(const Particles& before, const Particles& after)
{
    double farthest = 0.0;
    for (std::size_t i = 0; i < before.capacity; ++i) {
        if (before.birthStep[i] != Particles::kUnborn && before.birthStep[i] == after.birthStep[i]) {
            const glm::vec3 way(after.x[i] - before.x[i], after.y[i] - before.y[i], after.z[i] - before.z[i]);
            farthest = std::max(farthest, static_cast<double>(glm::length(way)));
        }
    }
    return farthest;
}

LiveScene started(const Scene& scene, const LiveOptions& options = {})
{
    Result<LiveScene> live = LiveScene::start(scene, options);
    if (!live) {
        qFatal("%s", live.error().text().c_str());
    }
    return std::move(live).value();
}

void play(LiveScene& live, int steps)
{
    for (int i = 0; i < steps; ++i) {
        QVERIFY(live.step(1.0 / 30.0).ok());
    }
}

} // namespace

class LiveTracksTest : public QObject {
    Q_OBJECT

private slots:
    void birthsFollowTheRate()
    {
        LiveScene live = started(animated(dots(30000), "emitter.rate=0:0:linear; 2:1"));
        play(live, 60);
        // Of 30000 in 5 s, a ramp of 2 s gives birth to half of what 2 s would.
        QVERIFY(near(static_cast<double>(live.living()), 6000.0, 120.0));
        LiveScene off = started(animated(dots(30000), "emitter.rate=0:1:hold; 1:0"));
        play(off, 200);
        QCOMPARE(off.living(), std::size_t{0});
    }

    void thereIsRoomForAllThatKeysLetLive()
    {
        Scene scene = animated(dots(30000), "emitter.rate=0:0:linear; 2:1");
        LiveScene usual = started(scene);
        scene.layers.front().emitter.rate = 0.0F; // what it has beside its key frames means nothing
        LiveScene none = started(scene);
        play(usual, 60);
        play(none, 60);
        QVERIFY(sameBits(usual.particles(0), none.particles(0)));
    }

    void theEmitterGoesItsWay_data()
    {
        QTest::addColumn<double>("stepsACall");
        QTest::newRow("one step a call") << 1.0;
        QTest::newRow("several steps a call") << 5.0;
        QTest::newRow("all steps in the first call") << 25.0;
        QTest::newRow("parts of steps are left over") << 2.5;
        QTest::newRow("less than a step a call") << 0.4;
    }
    void theEmitterGoesItsWay()
    {
        QFETCH(double, stepsACall);
        LiveOptions options;
        options.mostStepsAtOnce = 25;
        LiveScene live = started(animated(dots(6000), "emitter.position=0:0,0,0:linear; 1:3,0,0"), options);
        for (int steps = 0; steps < 25;) {
            const Result<int> made = live.step(stepsACall / 30.0);
            QVERIFY(made.ok());
            steps += made.value();
        }
        const Particles& particles = live.particles(0);
        int seen = 0;
        for (std::size_t i = 0; i < particles.capacity; ++i) {
            if (particles.birthStep[i] != Particles::kUnborn) {
                const double born = std::max(0.0, 24.0 / 30.0 - static_cast<double>(live.ages(0)[i]));
                QVERIFY(near(static_cast<double>(particles.x[i]), 3.0 * born, 1e-3));
                ++seen;
            }
        }
        QVERIFY(seen > 900);
    }

    void anObstaclePushesTheAirOnItsWayAndStandsAtItsEnd()
    {
        LiveScene live = started(besideAnObstacle());
        constexpr int kSteps = 4; // several a call: each goes a part of the way
        double pushed = 0.0;
        double calm = 0.0;
        for (int call = 0; call < 30; ++call) {
            const Particles before = live.particles(0);
            QCOMPARE(live.step(kSteps * live.stepSeconds()).value(), kSteps);
            calm = farthestApart(before, live.particles(0));
            pushed = std::max(pushed, calm);
        }
        QVERIFY2(pushed > 0.03, qPrintable(QString::number(pushed)));
        QVERIFY2(calm < 0.2 * pushed, qPrintable(QString::number(calm / pushed)));
    }

    void anObstacleGoesAsFarInEachOfSeveralStepsAsAlone_data()
    {
        QTest::addColumn<int>("before");
        QTest::addColumn<double>("stepsACall");
        QTest::addColumn<QByteArray>("keys");
        const QByteArray slow("0:-0.2,1,0:linear; 0.4:0.2,1,0");
        QTest::newRow("from the first step on") << 0 << 4.0 << slow;
        QTest::newRow("later") << 1 << 4.0 << slow;
        QTest::newRow("parts of steps are left over") << 1 << 2.5 << slow;
        QTest::newRow("farther than it is large") << 1 << 12.0 << QByteArray("0:-0.8,1,0:linear; 0.4:0.8,1,0");
    }
    void anObstacleGoesAsFarInEachOfSeveralStepsAsAlone()
    {
        QFETCH(int, before);
        QFETCH(double, stepsACall);
        QFETCH(QByteArray, keys);
        LiveScene alone = started(besideAnObstacle(keys.constData()));
        LiveOptions options;
        options.mostStepsAtOnce = 25;
        LiveScene together = started(besideAnObstacle(keys.constData()), options);
        play(alone, before);
        play(together, before);
        for (int call = 0; call < 4; ++call) {
            const Result<int> steps = together.step(stepsACall * together.stepSeconds());
            QVERIFY(steps.ok() && steps.value() > 1);
            play(alone, steps.value());
            const double apart = farthestApart(alone.particles(0), together.particles(0));
            QVERIFY2(apart < 1e-3, qPrintable(QString::number(apart)));
        }
    }

    /// Key frames of something else do not take the emitter out of the game's hand.
    void whatAGameMovesIsWhereItSaysBesideKeyFrames_data()
    {
        QTest::addColumn<QString>("keys");
        QTest::newRow("of the look") << "look.opacity=0:0.2; 1:1";
        QTest::newRow("of the emitter's normal") << "emitter.normal=0:0,1,0; 1:0,1,1";
    }
    void whatAGameMovesIsWhereItSaysBesideKeyFrames()
    {
        QFETCH(QString, keys);
        const Scene still = dots(6000);
        LiveScene plain = started(still);
        LiveScene keyed = started(animated(still, keys.toUtf8().constData()));
        for (int call = 1; call <= 10; ++call) {
            for (LiveScene* live : {&plain, &keyed}) {
                EmitterPose pose;
                pose.position.x = 0.1F * static_cast<float>(call);
                QVERIFY(live->setEmitter(0, pose).ok());
                QVERIFY(live->step(2.5 * live->stepSeconds()).ok());
            }
            QVERIFY(keyed.particles(0).x == plain.particles(0).x);
        }
    }

    void nothingIsBornWhereTheEmitterJumps_data()
    {
        QTest::addColumn<QString>("keys");
        QTest::newRow("a held key") << "emitter.position=0:0,0,0:hold; 0.5:3,0,0";
        QTest::newRow("the end of the loop") << "emitter.position=0:0,0,0; 0.49:0,0,0:hold; 0.5:3,0,0; 1:3,0,0";
        QTest::newRow("keys again") << "emitter.position=0:0,0,0; 0.2:0,0,0:hold; 0.21:3,0,0; 0.4:3,0,0; after=loop";
    }
    void nothingIsBornWhereTheEmitterJumps()
    {
        QFETCH(QString, keys);
        Scene scene = animated(dots(6000), keys.toUtf8().constData());
        scene.timeline.loop = true;
        scene.timeline.length = 30;
        LiveScene live = started(scene);
        play(live, 75);
        const Particles& particles = live.particles(0);
        int there = 0;
        for (std::size_t i = 0; i < particles.capacity; ++i) {
            if (particles.birthStep[i] != Particles::kUnborn) {
                QVERIFY(particles.x[i] == 0.0F || particles.x[i] == 3.0F);
                there += particles.x[i] == 3.0F ? 1 : 0;
            }
        }
        QVERIFY(there > 600);
        QVERIFY(static_cast<std::size_t>(there) + 600 < live.living());
    }

    void aLoopStartsAgain()
    {
        Scene scene = animated(dots(3000), "emitter.rate=0:1:hold; 0.5:0");
        scene.timeline.loop = true;
        scene.timeline.length = 30;
        LiveScene live = started(scene);
        play(live, 29);
        const std::size_t before = live.living();
        play(live, 10);
        QVERIFY(live.living() > before);
    }

    void withoutKeysNothingChanges()
    {
        LiveScene plain = started(dots(3000));
        LiveScene constant = started(animated(dots(3000), "motion.gravity=0:0; 1:0"));
        play(plain, 40);
        play(constant, 40);
        QVERIFY(tests::sameBits(plain.particles(0), constant.particles(0)));
    }
};

QTEST_GUILESS_MAIN(LiveTracksTest)
#include "live_tracks_test.moc"
