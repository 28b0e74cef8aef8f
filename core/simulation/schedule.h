#pragma once

#include "core/effect/sampling.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace fumage {

/// Births of an emission that changes over time, summed up from step 0 on in whole numbers, so that any step can be
/// reached at once.
struct BirthTable {
    std::vector<std::int64_t> before; ///< births before each step of a period, or up to where keys end; one more than
                                      ///< there are steps
    double perStep = 0.0; ///< births of each step beyond, where there are no periods
    std::int64_t mostAlive = 1; ///< at once
};

/// When each particle is born and how long it lives, in whole steps: closed forms, so that any step can be reached at
/// once.
///
/// Births repeat with a period of periodSteps; each period has birthsPerPeriod of them, spread over its first
/// windowSteps. A particle that is born at step b is alive at steps b to b + lifetimeSteps - 1. Between steps, its
/// birth is a random part of a step before b.
struct Schedule {
    float dt = 0.0F; ///< seconds of smoke a step: those of the film times timeline.time_scale
    std::int64_t lifetimeSteps = 1; ///< L = ceil(Ai / (fade dt)), eq. XIII of the 2012 model
    std::int64_t birthsPerPeriod = 1;
    std::int64_t periodSteps = 1;
    std::int64_t windowSteps = 1; ///< at most periodSteps
    /// Steps for which the source acts on the air in each period: windowSteps before they are made whole
    double emittingSteps = 1.0;
    std::int64_t firstStep = 0; ///< the step of frame 0; smoke may have been rising before it, or starts after it (< 0)
    std::int64_t loopSteps = 0; ///< 0 where the effect does not loop
    std::int64_t stepsPerFrame = 1;
    std::shared_ptr<const BirthTable> table; ///< null: as many births in each step
    bool betweenSteps = false; ///< births are spread over the time between two steps, each by its own random part of it

    /// Births before the given step, which is also the index of the first particle born at it or later. 0 before step
    /// 0.
    [[nodiscard]] std::int64_t birthsBefore(std::int64_t step) const;

    /// Index of the first particle that may be alive at a step.
    [[nodiscard]] std::int64_t firstAlive(std::int64_t step) const { return birthsBefore(step - lifetimeSteps + 1); }

    /// The birth index of the particle in a slot at a step: slots are birth indices modulo the capacity.
    /// @param slot of a particle that is alive, below slots
    /// @param slots capacity of the particles
    [[nodiscard]] std::int64_t birthIndex(std::int64_t step, std::int64_t slot, std::int64_t slots) const;

    /// Most particles that are ever alive at once.
    [[nodiscard]] std::int64_t capacity() const;

    /// The index that randomness sees: the same in every turn of a loop.
    [[nodiscard]] std::int64_t randomIndex(std::int64_t birthIndex) const
    {
        return loopSteps == 0 ? birthIndex : birthIndex % birthsPerPeriod;
    }

    /// The step that randomness and moving fields see: the same in every turn of a loop.
    [[nodiscard]] std::int64_t randomStep(std::int64_t step) const { return loopSteps == 0 ? step : step % loopSteps; }

    /// How much of the time from a step to the next the source acts on the air, 0 to 1: a burst that ends between two
    /// steps gives off no more for that.
    /// @param step 0 or more
    [[nodiscard]] float actsAfter(std::int64_t step) const;

    /// The step whose state is this frame.
    [[nodiscard]] std::int64_t stepOfFrame(std::int64_t frame) const { return firstStep + frame * stepsPerFrame; }
};

/// The time of a step since frame 0, s; in a loop within its length.
/// @param effect of the schedule @param step parts of steps too
[[nodiscard]] double secondsOfStep(const Schedule& schedule, const Timeline& timeline, double step);

/// Steps from step 0 on until nothing changes any more that a track says, or the timeline ends; in a loop, its length.
[[nodiscard]] std::int64_t changingSteps(const Schedule& schedule, const Timeline& timeline, const Track& track);

/// A point in a periodic or endless row of random values: two neighbours and the way between them.
struct RowPosition {
    std::int64_t before = 0;
    std::int64_t after = 0; ///< 0 after the last of a loop
    float fraction = 0.0F;
    std::int64_t cells = 0; ///< of a loop; 0: endless
};

/// Where a step lies in the row of random values that something has which changes cellsPerStep times a step; whole
/// numbers of them in a loop.
/// @param step 0 or more; parts of steps too
[[nodiscard]] RowPosition rowPosition(double step, const Schedule& schedule, double cellsPerStep);

/// A rate that changes over time, summed up over the steps since step 0: a phase that does not jump where the rate
/// does.
class RateSum {
public:
    RateSum(const Track& track, const Schedule& schedule, const Timeline& timeline);

    /// The phase at a step, in turns; beyond the keys it goes on as fast as at their end.
    /// @param step 0 or more; parts of steps too
    [[nodiscard]] double at(double step) const;
    /// Where a step lies in a row of random values, as of the other rowPosition().
    /// @param factor that the rate is multiplied by
    [[nodiscard]] RowPosition row(double step, const Schedule& schedule, double factor = 1.0) const;
    /// The phase at the end of the steps that were summed up: in a loop, of all of it.
    [[nodiscard]] double all() const { return m_before.back(); }

private:
    std::vector<double> m_before; ///< the phase at each step
    double m_perStep = 0.0; ///< beyond them
};

/// What a rate that changes over time has added up to, at a step, since particles of each age were born.
/// @param step of the schedule, 0 or more
/// @param factor that the rate is multiplied by
/// @param out gets one number for each whole age in steps, from 0 to one beyond the oldest particle that may live; goes
/// evenly from one to the next. O(steps of a life).
void sumOverAges(const Track& track, const Schedule& schedule, const Timeline& timeline, std::int64_t step,
    float factor, std::vector<float>& out);

/// @param effect in range
[[nodiscard]] Schedule makeSchedule(const SampledEffect& effect);

/// How many are born in the steps that lead to each frame. O(frames).
/// @param frames of the timeline, from 0 on
[[nodiscard]] std::vector<std::int64_t> birthsOfFrames(const Schedule& schedule, int frames);

} // namespace fumage
