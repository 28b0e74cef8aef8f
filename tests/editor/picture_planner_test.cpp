// What pictures give up to be there in time, by costs that are told and not measured.
#include "editor_helpers.h"
#include "picture_helpers.h"

#include "ui/preview/picture_planner.h"

using namespace fumage;
using namespace fumage::tests;
using namespace fumage::ui;

namespace {

constexpr int kFrame = 3;

/// A planner that has been told often enough what particles and pixels cost that it has come to believe it.
struct Told {
    Told(double sprite, double pixel)
    {
        for (int i = 0; i < 100; ++i) {
            constexpr int kMany = 1000000;
            planner.costs().noteSprites(kMany, static_cast<qint64>(sprite * kMany));
            planner.costs().notePixels(kMany, static_cast<qint64>(pixel * kMany));
        }
    }

    PicturePlan planFor(const Effect& effect, PreviewQuality quality)
    {
        RenderRequest request = requestFor(effect, kFrame);
        request.previewQuality = quality;
        request.simulation = 1;
        request.width = 1000;
        request.height = 1000;
        return planner.planFor(request);
    }

    /// Simulates all particles of an effect, so that they are at hand.
    void simulate(const Effect& effect)
    {
        RunningSimulator& running = planner.simulators().runningFor(planFor(effect, PreviewQuality::Full));
        QVERIFY(running.simulator.frame(kFrame, {}).ok());
        running.hasBegun = true;
    }

    PicturePlanner planner{std::make_shared<AirCache>()};
};

Effect effectOf(int particles)
{
    Effect effect = smallEffect();
    effect.emitter.count = particles;
    return effect;
}

} // namespace

class PicturePlannerTest : public QObject {
    Q_OBJECT

private slots:
    /// A drag has 60 frames/s to keep to, and what is played 30: it need not be as blurred.
    void aPlayedPictureIsSharperThanOneOfADrag()
    {
        const Effect effect = effectOf(1000);
        Told told(10.0, 20.0); // 20 ms for all pixels
        told.simulate(effect);
        QVERIFY(told.planFor(effect, PreviewQuality::Interactive).scale < 1.0);
        QCOMPARE(told.planFor(effect, PreviewQuality::Playback).scale, 1.0);
        QCOMPARE(told.planFor(effect, PreviewQuality::Full).scale, 1.0);
    }

    /// Particles that are there need not be simulated again: all of them are, and a share is drawn.
    void whatIsAtHandIsDrawnInPartRatherThanSimulatedAnew_data()
    {
        QTest::addColumn<PreviewQuality>("quality");
        QTest::addColumn<double>("sprite");
        QTest::newRow("of a drag") << PreviewQuality::Interactive << 1000.0;
        QTest::newRow("after a drag") << PreviewQuality::Intermediate << 50000.0;
    }
    void whatIsAtHandIsDrawnInPartRatherThanSimulatedAnew()
    {
        QFETCH(PreviewQuality, quality);
        QFETCH(double, sprite);
        const Effect effect = effectOf(64000);
        Told told(sprite, 0.1);
        const PicturePlan anew = told.planFor(effect, quality);
        QVERIFY(!anew.keepsAll && anew.sparse.empty() && anew.particles < 64000);
        told.simulate(effect);
        const PicturePlan plan = told.planFor(effect, quality);
        QVERIFY(plan.keepsAll && !plan.complete);
        QCOMPARE(plan.particles, 64000);
        QVERIFY(!plan.sparse.empty());
        QVERIFY(plan.drawnParticles() < 64000);
    }

    /// Or the smoke would flicker under the hand.
    void aDragKeepsToItsParticlesThoughTimesVary()
    {
        const Effect effect = effectOf(64000);
        Told told(570.0, 0.1);
        told.simulate(effect);
        const int drawn = told.planFor(effect, PreviewQuality::Interactive).drawnParticles();
        for (const double sprite : {900.0, 500.0, 800.0}) {
            told.planner.costs().noteSprites(1000, static_cast<qint64>(sprite * 1000));
            QCOMPARE(told.planFor(effect, PreviewQuality::Interactive).drawnParticles(), drawn);
        }
    }
};

FUMAGE_TEST_MAIN(PicturePlannerTest)
#include "picture_planner_test.moc"
