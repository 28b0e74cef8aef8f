#pragma once

#include "core/simulation/schedule.h"

namespace fumage {

/// How many particles are born in each step where the schedule may change between steps. What a step owes of a particle
/// goes on to the next, so that a rate keeps its mean whatever it changes into; and with a schedule that stays, and a
/// share of 1, births are those of Schedule::birthsBefore().
class BirthClock {
public:
    /// Births of the next step.
    /// @param schedule without a loop
    /// @param share of its births, 0 to 1, kept to 1/65536
    [[nodiscard]] std::int64_t next(const Schedule& schedule, float share);

    /// How much of the time after the next step the source acts on the air, see Schedule::actsAfter().
    [[nodiscard]] float acts(const Schedule& schedule) const { return schedule.actsAfter(m_step); }

    /// Whether the next step is one in which particles are born: always but after the end of a burst.
    [[nodiscard]] bool emits(const Schedule& schedule) const
    {
        return m_step % schedule.periodSteps < schedule.windowSteps;
    }

    /// Begins again, as at the first step: a burst comes once more.
    void restart() { *this = BirthClock(); }

private:
    std::int64_t m_step = 0; ///< since the beginning
    std::int64_t m_window = 1; ///< parts of a birth, see m_owed
    std::int64_t m_owed = 0; ///< births that are owed, in 1 / m_window of one; less than one has been given too much,
                             ///< so that the first comes at once
};

} // namespace fumage
