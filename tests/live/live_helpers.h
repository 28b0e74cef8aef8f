#pragma once

#include "tests/helpers.h"
#include "tests/live/restless_game.h"

namespace fumage::tests {

inline LiveSimulation started(const Effect& effect, const LiveOptions& options = {})
{
    Result<LiveSimulation> made = LiveSimulation::start(effect, options);
    if (!made) {
        qFatal("%s", made.error().text().c_str());
    }
    return std::move(made).value();
}

inline void go(LiveSimulation& live, int steps)
{
    for (int i = 0; i < steps; ++i) {
        QCOMPARE(live.step(live.stepSeconds()).value(), 1);
    }
}

} // namespace fumage::tests
