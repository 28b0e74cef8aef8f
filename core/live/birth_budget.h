#pragma once

#include <cstddef>

namespace fumage {

/// How long a step took.
struct StepTimes {
    double air = 0.0; ///< s
    double particles = 0.0; ///< s
};

/// Finds the share of births with which 99 of 100 steps keep within a time. The number of particles follows births only
/// after a lifetime, so a share that fell as long as steps are too long would fall much too far: it follows instead
/// from what a particle costs, and so is right at once.
///
/// As much of the time is left over as the longest of a hundred steps takes beyond what was expected of it. Thins at
/// once and comes back slowly, and only where there is a fifth more room than is used, so that it does not swing. A
/// step that takes far longer than others has been interrupted, which fewer particles do not mend: it counts as twice
/// as long, and not among those hundred. What comes out depends on the times: with those of a machine two runs differ.
class BirthBudget {
public:
    /// @param seconds a step may take
    explicit BirthBudget(double seconds)
        : m_seconds(seconds)
    {
    }

    /// @param living particles that the step has moved
    /// @param full   particles that there are with all births
    /// @return the share of births from now on, kMinShare to 1
    float observe(const StepTimes& times, std::size_t living, std::size_t full);

    [[nodiscard]] float share() const { return m_share; }

    /// Whether births at kMinShare would still be too many, as where air alone takes longer than the budget: it is not
    /// kept then, and fewer particles would not help.
    [[nodiscard]] bool isHopeless() const { return m_isHopeless; }

    /// Some smoke is left whatever it takes: air that alone takes longer than the budget would otherwise end it.
    static constexpr float kMinShare = 0.05F;

private:
    /// Learns from a step what particles and air cost, and how far steps are from it.
    void learn(const StepTimes& times, double living);

    double m_seconds;
    double m_air = 0.0; ///< s a step, smoothed
    double m_perParticle = 0.0; ///< s, smoothed; 0: not known
    double m_longest = 1.25; ///< what 99 of 100 steps take at most, over what is expected; a guess at first
    bool m_wasLong = false; ///< whether the last step was longer than those
    float m_share = 1.0F;
    bool m_isHopeless = false;
};

} // namespace fumage
