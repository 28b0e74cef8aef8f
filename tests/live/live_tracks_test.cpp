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

LiveScene started(const Scene& scene)
{
    Result<LiveScene> live = LiveScene::start(scene);
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

    void theEmitterGoesItsWay()
    {
        LiveScene live = started(animated(dots(6000), "emitter.position=0:0,0,0:linear; 1:3,0,0"));
        play(live, 25);
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
