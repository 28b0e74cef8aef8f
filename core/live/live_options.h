#pragma once

#include "core/base/result.h"

#include <functional>

namespace fumage {

/// What is fixed when smoke starts inside a game.
struct LiveOptions {
    /// In place of the effect's, 1 to 240, best as many as the game has; 0: those of the effect
    int stepsPerSecond = 0;
    /// Alive at once in all layers, up to kMaxParticles; memory is taken for all of them, each layer has its share of
    /// them, and births are thinned so that they suffice. 0: as many as the layers have at the start
    int mostParticles = 0;
    /// Milliseconds that a step of the simulation may take, kept by thinning births; 0: none. With one, two runs differ
    double budgetMs = 0.0;
    int mostStepsAtOnce = 8; ///< in one call of step(), 1 or more: time beyond it is let go, so that a game that has
                             ///< stood still does not race
    std::function<double()> clock{}; ///< that the budget is measured with, s from any start on, asked three times a
                                     ///< step; empty: the machine's. Throws nothing
};

/// Whether options can be.
/// @error TooLarge, OutOfRange
[[nodiscard]] Status checkOptions(const LiveOptions& options);

} // namespace fumage
