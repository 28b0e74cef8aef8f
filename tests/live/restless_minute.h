#pragma once

#include "tests/live/counted_heap.h"
#include "tests/live/live_helpers.h"

namespace fumage::tests {

/// A minute of changes at random: no number that is none, no jump beyond the smoke's own motion, and nothing allocated
/// once it has settled.
/// @param swirls largest speed of noise that carries smoke, m/s; see longestJump()
/// @param jump   the longest that is not motion, m
/// @param most   becomes the most particles that lived
inline void endureAMinute(LiveSimulation& live, const Effect& effect, float swirls, float jump, std::size_t& most)
{
    RestlessGame game(effect);
    Particles before = live.particles();
    most = 0;
    for (int step = 0; step < 3600; ++step) {
        [[maybe_unused]] const std::size_t allocated = allocations();
        before.copySlots(live.particles(), 0, before.x.size());
        QVERIFY(game.act(live, step).ok());
        go(live, 1);
#ifndef FUMAGE_LOOPS_ALLOCATE
        constexpr int kSettled = 10;
        if (step >= kSettled) {
            QCOMPARE(allocations(), allocated);
        }
#endif
        QVERIFY2(isFinite(live.particles()), qPrintable(QString::number(step)));
        QVERIFY2(longestJump(before, live.particles(), swirls) < jump,
            qPrintable(QStringLiteral("%1: %2").arg(step).arg(
                static_cast<double>(longestJump(before, live.particles(), swirls)))));
        most = std::max(most, live.living());
    }
}

} // namespace fumage::tests
