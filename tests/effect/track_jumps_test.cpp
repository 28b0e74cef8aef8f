// Where a track jumps: at the end of a held key, and where its keys begin again.

#include "tests/helpers.h"

#include "core/effect/known_parameter.h"
#include "core/effect/track_jumps.h"

#include <algorithm>
#include <cmath>

using namespace fumage;

namespace {

/// A ramp of a second, from 1 to 5.
Track ramp(Extrapolation before, Extrapolation after)
{
    return {&knownParameter("glow.emission"), {{0.0, 1.0F, Ease::Linear}, {1.0, 5.0F}}, before, after};
}

/// 1 for half a second, then a ramp from 2 to 5.
Track held(Extrapolation before, Extrapolation after)
{
    return {&knownParameter("glow.emission"), {{0.0, 1.0F, Ease::Hold}, {0.5, 2.0F, Ease::Linear}, {1.0, 5.0F}}, before,
        after};
}

/// From 1 to 5, which holds until the keys begin again with 1.
Track heldAtTheEnd()
{
    return {&knownParameter("glow.emission"), {{0.0, 1.0F}, {0.5, 5.0F, Ease::Hold}, {1.0, 1.0F}}, Extrapolation::Hold,
        Extrapolation::Loop};
}

double numberAt(const Track& track, double seconds)
{
    return static_cast<double>(std::get<float>(track.at(seconds)));
}

} // namespace

Q_DECLARE_METATYPE(fumage::Track)

class TrackJumpsTest : public QObject {
    Q_OBJECT

private slots:
    void jumpsAreFound_data()
    {
        using enum Extrapolation;
        QTest::addColumn<Track>("track");
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::addColumn<bool>("jumps");
        const auto row = [](const char* name, const Track& track, double from, double to, bool jumps) {
            QTest::newRow(name) << track << from << to << jumps;
        };
        row("up to the last key", ramp(Hold, Loop), 0.9, 1.0, false);
        row("from the last key on", ramp(Hold, Loop), 1.0, 1.1, true);
        row("past the last key", ramp(Hold, Loop), 0.95, 1.05, true);
        row("within the second turn", ramp(Hold, Loop), 1.1, 1.9, false);
        row("up to the third turn", ramp(Hold, Loop), 1.9, 2.0, true);
        row("from its beginning on", ramp(Hold, Loop), 2.0, 2.1, false);
        row("past the second turn", ramp(Hold, Loop), 1.95, 2.05, true);
        row("past several turns", ramp(Hold, Loop), 0.5, 7.5, true);
        row("past the last key, which holds", ramp(Hold, Hold), 0.5, 7.5, false);
        row("up to the first key", ramp(Loop, Hold), -0.1, 0.0, true);
        row("past the first key", ramp(Loop, Hold), -0.05, 0.05, true);
        row("within the turn before", ramp(Loop, Hold), -1.0, -0.1, false);
        row("past the turn before", ramp(Loop, Hold), -1.05, -0.95, true);
        row("there and back", ramp(PingPong, PingPong), -3.3, 4.4, false);
        row("up to a held key's end", held(Hold, PingPong), 0.4, 0.5, true);
        row("to the last key and back", held(Hold, PingPong), 0.9, 1.1, false);
        row("back to a held key's end", held(Hold, PingPong), 1.4, 1.5, false);
        row("back past it", held(Hold, PingPong), 1.5, 1.6, true);
        row("to the first key and on", held(Hold, PingPong), 1.9, 2.1, false);
        row("past it again", held(Hold, PingPong), 2.4, 2.6, true);
        row("before the first key", held(PingPong, Hold), -0.6, -0.4, true);
        row("past a held end", heldAtTheEnd(), 0.95, 1.05, true);
        row("past a held end again", heldAtTheEnd(), 2.95, 3.05, true);
        row("within a turn", heldAtTheEnd(), 2.05, 2.95, false);
    }
    void jumpsAreFound()
    {
        QFETCH(Track, track);
        QFETCH(double, from);
        QFETCH(double, to);
        QFETCH(bool, jumps);
        QCOMPARE(track.jumpsIn(from, to), jumps);
        // Where nothing jumps, it goes on in small steps. The steepest of the pieces above changes by 8 in a second.
        double farthest = 0.0;
        constexpr int kParts = 100'000;
        const double part = (to - from) / kParts;
        for (int i = 0; i < kParts; ++i) {
            const double end = i + 1 == kParts ? to : from + (i + 1) * part;
            const double change = numberAt(track, end) - numberAt(track, from + i * part);
            farthest = std::max(farthest, std::abs(change));
        }
        QCOMPARE(farthest > 0.5, jumps);
    }

    void aLoopThatClosesDoesNotJump()
    {
        const Track open = ramp(Extrapolation::Hold, Extrapolation::Hold);
        QVERIFY(!jumpsOnWay(open, 0.2, 0.9, 1.0));
        QVERIFY(jumpsOnWay(open, 0.9, 0.2, 1.0));
        QVERIFY(!jumpsOnWay(ramp(Extrapolation::Hold, Extrapolation::PingPong), 1.9, 0.1, 2.0));
        QVERIFY(jumpsOnWay(held(Extrapolation::Hold, Extrapolation::PingPong), 1.9, 0.6, 2.0));
    }
};

QTEST_GUILESS_MAIN(TrackJumpsTest)
#include "track_jumps_test.moc"
