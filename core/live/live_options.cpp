#include "core/live/live_options.h"

#include "core/effect/effect.h"

namespace fumage {

namespace {

/// As many frames a second as an effect has at most.
constexpr int kMaxStepsPerSecond = 240;

} // namespace

Status checkOptions(const LiveOptions& options)
{
    if (options.mostParticles < 0 || options.mostParticles > kMaxParticles) {
        return Error{ErrorCode::TooLarge, makeMessage("%1 particles are not possible", options.mostParticles), {},
            makeMessage("Ask for 1 to %1, or 0 for as many as the effect has", kMaxParticles)};
    }
    if (options.stepsPerSecond < 0 || options.stepsPerSecond > kMaxStepsPerSecond) {
        return Error{ErrorCode::OutOfRange, makeMessage("%1 steps a second are not possible", options.stepsPerSecond),
            {}, makeMessage("Ask for 1 to %1, or 0 for those of the effect", kMaxStepsPerSecond)};
    }
    if (options.mostStepsAtOnce < 1 || !(options.budgetMs >= 0.0)) {
        return Error{ErrorCode::OutOfRange,
            makeMessage("a budget below 0 or less than one step at once is not possible"), {},
            makeMessage("Ask for 0 ms or more, and for 1 step or more")};
    }
    return Done{};
}

} // namespace fumage
