#pragma once

#include "core/scene/scene.h"
#include "core/export/sequence.h"

namespace fumage {

/// What frames cost on a machine of two cores, roughly: good enough to divide work by, and computed without measuring
/// anything.
struct FarmCost {
    double frame = 0.0; ///< s, to draw and write one
    double start = 0.0; ///< s, for a farm to start a task
    double airStep = 0.0; ///< s, of the air; 0: there is none
    double particleStep = 0.0; ///< s, of all particles
    std::int64_t stepsPerFrame = 1;
    std::int64_t firstStep = 0; ///< of the air, that frame 0 shows
    std::int64_t loopSteps = 0; ///< that the whole air of a loop has; 0: it does not loop
    std::int64_t lifetimeSteps = 1; ///< particles are simulated from no farther back

    /// s, from its start until a task can draw the frame of a number as its first: the air from its beginning (of a
    /// loop, all of it), the particles for as long as one lives.
    [[nodiscard]] double reach(int number) const;
};

/// Steps times cells, steps times particles, particles and pixels, each with the time that one takes
/// (resources/docs/performance.md).
[[nodiscard]] FarmCost farmCost(const Scene& scene);

/// Most tasks that a job is divided into; Slurm takes 1001 where nobody has raised it.
inline constexpr int kMaxTasks = 1000;

/// How many frames a task has: the fewest for which the tasks together spend no more on getting to their frames than on
/// drawing them. As few as these, so that many machines have work; no fewer, so that at least half of their work
/// counts. At most kMaxTasks tasks.
/// @param cost of farmCost(), or one's own
/// @return 1 to frames.count()
[[nodiscard]] int framesPerTask(const FarmCost& cost, const FrameRange& frames);

/// A task's frames.
/// @param task from 0, below taskCount()
[[nodiscard]] FrameRange framesOfTask(const FrameRange& frames, int perTask, int task);
[[nodiscard]] int taskCount(const FrameRange& frames, int perTask);

} // namespace fumage
