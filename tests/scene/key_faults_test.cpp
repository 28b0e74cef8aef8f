// What key frames do that nobody may want, and how it is mended.

#include "tests/helpers.h"

#include "core/effect/known_parameter.h"
#include "core/export/remarks.h"
#include "core/scene/key_faults.h"

using namespace fumage;

namespace {

constexpr const Parameter& kRate = knownParameter("emitter.rate");
constexpr const Parameter& kGusts = knownParameter("wind.gust_rate");
constexpr double kLength = 2.0; // s

Timeline looping()
{
    Timeline timeline;
    timeline.frameRate = 30;
    timeline.length = 60;
    timeline.loop = true;
    return timeline;
}

float at(const Track& track, double seconds)
{
    return std::get<float>(track.at(seconds));
}

Track trackOf(std::vector<KeyFrame> keys, const Parameter& parameter = kRate)
{
    return {&parameter, std::move(keys)};
}

} // namespace

Q_DECLARE_METATYPE(fumage::Track)

class KeyFaultsTest : public QObject {
    Q_OBJECT

private slots:
    void faultsAreFound_data()
    {
        using Faults = std::vector<KeyFault>;
        QTest::addColumn<Track>("track");
        QTest::addColumn<bool>("loop");
        QTest::addColumn<Faults>("faults");
        const Track closed = trackOf({{0.0, 0.2F}, {1.0, 1.0F}, {kLength, 0.2F}});
        const Track open = trackOf({{0.0, 0.2F}, {1.0, 1.0F}});
        const Track late = trackOf({{0.0, 0.2F}, {3.0, 0.2F}});
        const Track repeats{&kRate, {{0.0, 0.2F}, {0.5, 1.0F}, {1.0, 0.2F}}, {}, Extrapolation::Loop};
        QTest::newRow("closed") << closed << true << Faults{};
        QTest::newRow("open") << open << true << Faults{KeyFault::OpenLoop};
        QTest::newRow("open, played once") << open << false << Faults{};
        QTest::newRow("repeats in time") << repeats << true << Faults{};
        QTest::newRow("late") << late << true << Faults{KeyFault::AfterEnd};
        QTest::newRow("late, played once") << late << false << Faults{KeyFault::AfterEnd};
        const std::vector<KeyFrame> held{{0.0, 0.2F, Ease::Hold}, {1.0, 1.0F}, {kLength, 0.2F}};
        QTest::newRow("a burst") << trackOf(held) << true << Faults{};
        QTest::newRow("gusts that jump") << trackOf(held, kGusts) << true << Faults{KeyFault::RateJumps};
    }
    void faultsAreFound()
    {
        QFETCH(Track, track);
        QFETCH(bool, loop);
        QFETCH(std::vector<KeyFault>, faults);
        Timeline timeline = looping();
        timeline.loop = loop;
        QVERIFY(keyFaults(track, timeline) == faults);
        for (const KeyFault fault : {KeyFault::OpenLoop, KeyFault::AfterEnd, KeyFault::RateJumps}) {
            const bool isThere = std::ranges::find(faults, fault) != faults.end();
            QCOMPARE(withoutFault(track, fault, timeline) == track, !isThere); // what is whole stays to the bit
        }
    }

    void anOpenLoopIsClosed()
    {
        for (const Extrapolation outside : {Extrapolation::Hold, Extrapolation::Loop, Extrapolation::PingPong}) {
            Track track = trackOf({{0.25, 0.2F}, {1.0, 1.0F}, {1.5, 0.4F}, {5.0, 0.7F}});
            track.before = track.after = outside;
            const float begin = at(track, 0.0);
            const Track mended = withoutFault(track, KeyFault::OpenLoop, looping());
            QCOMPARE(at(mended, 0.0), begin);
            QCOMPARE(at(mended, kLength), begin);
            QCOMPARE(at(mended, 1.0), 1.0F); // keys within stay
            QVERIFY(keyFaults(mended, looping()).empty());
            QVERIFY(checkTrack(mended).ok());
        }
    }

    /// t' = t * length / last, and the curve is the same one, faster.
    void lateKeysAreMovedInInProportion()
    {
        Track track = trackOf({{0.0, 0.2F, Ease::Linear}, {2.0, 1.0F, Ease::Free}, {4.0, 0.2F, Ease::Free}});
        track.keys[1].slopeIn = track.keys[1].slopeOut = glm::vec3(0.1F, 0.0F, 0.0F);
        const Track mended = withoutFault(track, KeyFault::AfterEnd, looping());
        QCOMPARE(mended.keys.size(), track.keys.size());
        for (int i = 0; i <= 40; ++i) {
            QVERIFY(tests::near(at(mended, i * kLength / 40), at(track, i * 4.0 / 40), 1e-5));
        }
        QVERIFY(keyFaults(mended, looping()).empty());
    }

    void aSceneIsMendedWhole()
    {
        Scene scene;
        scene.timeline = looping();
        scene.layers.resize(3);
        for (Layer& layer : scene.layers) {
            layer.tracks.set(trackOf({{0.0, 0.2F}, {3.0, 1.0F}}));
        }
        scene.layers[1].locked = true;
        scene.layers[2].visible = false;
        scene.tracks.set(trackOf({{0.0, 0.2F, Ease::Hold}, {1.0, 1.0F}}, kGusts));
        QVERIFY(hasKeyFaults(scene));
        const Scene mended = withoutKeyFaults(scene);
        QVERIFY(!hasKeyFaults(mended));
        QVERIFY(mended.layers[1] == scene.layers[1] && mended.layers[2] == scene.layers[2]);
        QVERIFY(!(mended.layers[0] == scene.layers[0]) && !(mended.tracks == scene.tracks));
        QVERIFY(withoutKeyFaults(mended) == mended);
        scene.layers.erase(scene.layers.begin());
        scene.tracks = {};
        QVERIFY(!hasKeyFaults(scene)); // nothing that may be mended
    }

    void eachFaultIsSaidBeforeAnExport()
    {
        Scene scene;
        scene.timeline = looping();
        scene.tracks.set(trackOf({{0.0, 0.2F, Ease::Hold}, {1.0, 0.6F}, {3.0, 1.0F}}, kGusts));
        std::string said;
        for (const Message& remark : remarksOn(scene, ExportPlan())) {
            said += remark.text() + "\n";
        }
        for (const char* part : {"does not end as it begins", "after the end of the timeline", "with a jerk"}) {
            QVERIFY2(said.find(part) != std::string::npos, said.c_str());
        }
    }
};

QTEST_GUILESS_MAIN(KeyFaultsTest)
#include "key_faults_test.moc"
