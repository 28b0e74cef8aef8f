// Key frames on a curve that stays where it is: what is added, slopes, and what sets them.

#include "tests/helpers.h"

#include "core/effect/known_parameter.h"
#include "core/effect/track_edits.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace fumage;

namespace {

constexpr const Parameter& kEmission = knownParameter("glow.emission");
constexpr const Parameter& kPosition = knownParameter("emitter.position");
constexpr const Parameter& kNormal = knownParameter("emitter.normal");
constexpr double kLength = 10.0; ///< s

/// Random numbers of the generator alone: distributions differ from library to library.
double drawn(std::mt19937& random, double from, double to)
{
    return from + (to - from) * static_cast<double>(random()) / 4294967296.0;
}

/// A track of 1 to 6 keys, well inside the hard range, of a few eases.
Track anyTrack(std::mt19937& random, const std::vector<Ease>& eases)
{
    Track track{&kEmission, {}};
    const auto slope = [&] { return glm::vec3(static_cast<float>(drawn(random, -5.0, 5.0)), 0.0F, 0.0F); };
    const std::size_t count = 1 + random() % 6;
    while (track.keys.size() < count) {
        KeyFrame key{std::floor(drawn(random, 30.0, 270.0)) / 30.0, static_cast<float>(drawn(random, 500.0, 505.0)),
            eases[random() % eases.size()]};
        if (key.ease == Ease::Free) {
            key.slopeIn = slope();
            key.slopeOut = slope();
        }
        setKey(track, key);
    }
    return track;
}

double numberAt(const Track& track, double seconds)
{
    return static_cast<double>(std::get<float>(track.at(seconds)));
}

} // namespace

class TrackEditsTest : public QObject {
    Q_OBJECT

private slots:
    void aKeyOnTheCurveLeavesItThere_data()
    {
        QTest::addColumn<QList<int>>("eases");
        QTest::newRow("auto") << QList<int>{0};
        QTest::newRow("linear") << QList<int>{1};
        QTest::newRow("hold") << QList<int>{2};
        QTest::newRow("free") << QList<int>{3};
        QTest::newRow("auto and free") << QList<int>{0, 3};
        QTest::newRow("auto and linear") << QList<int>{0, 1};
        QTest::newRow("auto and hold") << QList<int>{0, 2};
        QTest::newRow("free, linear and hold") << QList<int>{1, 2, 3};
        QTest::newRow("all") << QList<int>{0, 1, 2, 3};
    }
    void aKeyOnTheCurveLeavesItThere()
    {
        QFETCH(QList<int>, eases);
        std::vector<Ease> some;
        std::transform(
            eases.begin(), eases.end(), std::back_inserter(some), [](int ease) { return static_cast<Ease>(ease); });
        std::mt19937 random(7);
        for (int trial = 0; trial < 400; ++trial) {
            const Track before = anyTrack(random, some);
            Track after = before;
            const double seconds = std::floor(drawn(random, 0.0, 300.0)) / 30.0;
            QCOMPARE(insertKey(after, seconds), seconds);
            QVERIFY(checkTrack(after));
            QVERIFY(keyAt(after, seconds) != nullptr);
            for (int i = 0; i < 100; ++i) {
                const double time = kLength * i / 100.0;
                constexpr double kRounding = 3e-4; // of values about 500, whose floats are 3e-5 apart
                QVERIFY(std::abs(numberAt(before, time) - numberAt(after, time)) <= kRounding);
            }
        }
    }

    void whereAKeyIsNoneIsAdded()
    {
        Track track{&kEmission, {{0.0, 1.0F}, {1.0, 2.0F}}};
        const Track before = track;
        QCOMPARE(insertKey(track, 1.0004), 1.0);
        QVERIFY(track == before);
        track.after = Extrapolation::Loop;
        QCOMPARE(insertKey(track, 5.25), 0.25);
        QCOMPARE(track.keys.size(), std::size_t{3});
    }

    void aKeyIsAddedAmongTheTimesThatKeysMayHave()
    {
        for (const double seconds : {-5.0, kMaxKeySeconds + 0.01, 1e300}) {
            Track track{&kEmission, {{1.0, 1.0F}, {2.0, 2.0F}}};
            const double expected = seconds < 0.0 ? 0.0 : kMaxKeySeconds;
            QCOMPARE(insertKey(track, seconds), expected);
            QVERIFY(checkTrack(track));
            QCOMPARE(track.keys.size(), std::size_t{3});
        }
    }

    /// Where smooth pieces, lines and held values meet, whatever came before, and in all components.
    void keysAddedOneAfterTheOtherLeaveTheCurveThere()
    {
        std::mt19937 random(23);
        const auto vector = [&](double most) {
            const auto part = [&] { return static_cast<float>(drawn(random, -most, most)); };
            return glm::vec3(part(), part(), part());
        };
        int arrivals = 0;
        for (int trial = 0; trial < 300; ++trial) {
            Track before{&kPosition, {}};
            const std::size_t count = 2 + random() % 5;
            while (before.keys.size() < count) {
                KeyFrame key{
                    std::floor(drawn(random, 0.0, 300.0)) / 30.0, vector(1.0), static_cast<Ease>(random() % 4)};
                if (key.ease == Ease::Free || (key.ease != Ease::Auto && random() % 4 == 0)) {
                    key.ownArrival = key.ease != Ease::Free;
                    key.slopeIn = vector(2.0);
                    key.slopeOut = key.ownArrival ? glm::vec3(0.0F) : vector(2.0);
                }
                setKey(before, key);
            }
            Track after = before;
            for (int i = 0; i < 4; ++i) {
                insertKey(after, std::floor(drawn(random, -30.0, 330.0)) / 30.0);
                QVERIFY(checkTrack(after));
            }
            for (const KeyFrame& key : before.keys) {
                const KeyFrame& now = *keyAt(after, key.seconds);
                QVERIFY(now.value == key.value);
                QVERIFY(now.ease == key.ease || (key.ease == Ease::Auto && now.ease == Ease::Free));
                arrivals += static_cast<int>(now.ownArrival && !key.ownArrival);
            }
            for (int i = -40; i <= 340; ++i) {
                const double time = i / 30.0;
                const glm::vec3 way = std::get<glm::vec3>(before.at(time)) - std::get<glm::vec3>(after.at(time));
                constexpr float kRounding = 2e-5F; // 1e-5 of the range of the values
                QVERIFY2(std::abs(way.x) <= kRounding && std::abs(way.y) <= kRounding && std::abs(way.z) <= kRounding,
                    qPrintable(QStringLiteral("trial %1, %2 s: %3, %4, %5")
                                   .arg(trial)
                                   .arg(time)
                                   .arg(way.x)
                                   .arg(way.y)
                                   .arg(way.z)));
            }
        }
        QVERIFY(arrivals > 50); // such keys were met
    }

    void aLinearKeyIsArrivedAtAsItSays()
    {
        Track track{&kEmission, {{0.0, 1.0F}, {1.0, 2.0F, Ease::Linear}, {2.0, 0.0F}}};
        QCOMPARE(slopeAtKey(track, 1, false).x, 0.0F); // it turns there
        track.keys[1].slopeIn.x = 2.0F;
        QCOMPARE(slopeAtKey(track, 1, false).x, 0.0F);
        track.keys[1].ownArrival = true;
        QCOMPARE(slopeAtKey(track, 1, false).x, 2.0F);
        QCOMPARE(slopeAtKey(track, 1, true).x, -2.0F); // straight to the next
        QCOMPARE(numberAt(track, 1.5), 1.0);
        stretchSlopes(track.keys[1], 4.0);
        QCOMPARE(track.keys[1].slopeIn.x, 0.5F);
        track.keys[1].ease = Ease::Auto; // which has the slope of a smooth one, whatever stands there
        QCOMPARE(slopeAtKey(track, 1, false).x, 0.0F);
    }

    void slopesStayNumbers()
    {
        // As near to each other as numbers can be.
        Track track{&kEmission, {{0.0, 1.0F}, {5e-324, 500.0F}, {1.0, 2.0F, Ease::Free, glm::vec3(3e37F), {}}}};
        QVERIFY(checkTrack(track));
        insertKey(track, 0.5);
        QVERIFY(checkTrack(track));
        stretchSlopes(track.keys.back(), 1e-7);
        QVERIFY(checkTrack(track));
        QVERIFY(std::isfinite(numberAt(track, 0.25)));
    }

    void allComponentsStay()
    {
        const Track before{&kPosition,
            {{0.0, glm::vec3(0.0F)}, {1.0, glm::vec3(1.0F, -1.0F, 3.0F)}, {2.0, glm::vec3(4.0F, 2.0F, 3.0F)}}};
        Track after = before;
        insertKey(after, 1.5);
        for (int i = 0; i <= 100; ++i) {
            const glm::vec3 way = std::get<glm::vec3>(before.at(0.02 * i)) - std::get<glm::vec3>(after.at(0.02 * i));
            QVERIFY(std::abs(way.x) + std::abs(way.y) + std::abs(way.z) < 1e-5F);
        }
    }

    void slopesAreThoseOfTheCurve()
    {
        std::mt19937 random(11);
        for (int trial = 0; trial < 200; ++trial) {
            Track track = anyTrack(random, {Ease::Auto, Ease::Linear, Ease::Hold, Ease::Free});
            for (KeyFrame& key : track.keys) {
                key.value = std::get<float>(key.value) - 500.0F + 1.0F; // small values, for their floats
            }
            for (std::size_t i = 0; i + 1 < track.keys.size(); ++i) {
                const double from = track.keys[i].seconds;
                const double length = track.keys[i + 1].seconds - from;
                constexpr double kStep = 0.02; // of the piece
                const double middle = from + 0.5 * length;
                // Of a cubic the difference of sixths and the one of thirds give the slope exactly.
                const auto around = [&](double step) {
                    return (numberAt(track, middle + step * length) - numberAt(track, middle - step * length))
                        / (2.0 * step * length);
                };
                const double slope = (4.0 * around(kStep) - around(2.0 * kStep)) / 3.0;
                const bool isCut = numberAt(track, middle - 2.0 * kStep * length) <= 0.0
                    || numberAt(track, middle + 2.0 * kStep * length) <= 0.0; // by the hard range
                const double told = static_cast<double>(slopeBetweenKeys(track, middle).x);
                QVERIFY(isCut || std::abs(slope - told) < 1e-3 * (1.0 + std::abs(told)) + 1e-4 / length);
                QCOMPARE(slopeAtKey(track, i, true).x, slopeBetweenKeys(track, from).x);
            }
        }
        const Track one{&kEmission, {{1.0, 2.0F}}};
        QCOMPARE(slopeAtKey(one, 0, true), glm::vec3(0.0F));
        const Track turns{&kNormal, {{0.0, glm::vec3(0.0F, 1.0F, 0.0F)}, {1.0, glm::vec3(1.0F, 0.0F, 0.0F)}}};
        QCOMPARE(slopeAtKey(turns, 0, true), glm::vec3(0.0F));
    }

    void aKeyIsMadeFreeWithTheSlopesThatItHas()
    {
        const Track before{&kEmission, {{0.0, 1.0F}, {1.0, 3.0F}, {3.0, 4.0F}}};
        Track track = before;
        freeKey(track, 1);
        QCOMPARE(track.keys[1].ease, Ease::Free);
        QVERIFY(track.keys[1].slopeIn.x > 0.0F);
        for (int i = 0; i <= 100; ++i) {
            QVERIFY(std::abs(numberAt(before, 0.03 * i) - numberAt(track, 0.03 * i)) < 2e-6);
        }
        // Where the way to it is straight, it can arrive with another slope only if that is a free one.
        track.keys = {{0.0, 1.0F, Ease::Linear}, {1.0, 3.0F, Ease::Linear}, {3.0, 4.0F}};
        setSlopes(track, 1, glm::vec3(0.0F), std::nullopt);
        QCOMPARE(track.keys[0].ease, Ease::Free);
        QCOMPARE(track.keys[0].slopeOut.x, 2.0F);
        QCOMPARE(track.keys[1].slopeIn.x, 0.0F);
        QCOMPARE(track.keys[1].slopeOut.x, 0.5F);
        track.keys = {{0.0, 1.0F, Ease::Linear}, {1.0, 3.0F, Ease::Linear}, {3.0, 4.0F}};
        setSlopes(track, 1, std::nullopt, glm::vec3(0.0F));
        QCOMPARE(track.keys[0].ease, Ease::Linear);
        QCOMPARE(track.keys[1].slopeIn.x, 2.0F);
    }
};

QTEST_APPLESS_MAIN(TrackEditsTest)
#include "track_edits_test.moc"
