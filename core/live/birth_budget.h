#pragma once

#include <cstddef>

namespace fumage {

/// How long a step took.
struct StepTimes {
    double air = 0.0; ///< s
    double particles = 0.0; ///< s
};

/// Finds the share of births with which steps keep within a time. The number of particles follows births only after a lifetime, so a share that fell as
/// long as steps are too long would fall much too far: it follows instead from what a particle costs, and so is right at once.
///
/// Thins at once and comes back slowly, and only where there is a fifth more room than is used, so that it does not swing.
/// A step that takes far longer than others has been interrupted and counts as twice as long.
/// What comes out depends on the clock: two runs differ.
class BirthBudget {
public:
    /// @param seconds a step may take
    explicit BirthBudget(double seconds)
        : m_seconds(seconds)
    {
    }

    /// @param living particles that the step has moved
    /// @param full   particles that there are with all births
    /// @return the share of births from now on, kLeastShare to 1
    float observe(const StepTimes& times, std::size_t living, std::size_t full);

    [[nodiscard]] float share() const { return m_share; }

    /// Some smoke is left whatever it takes: air that alone takes longer than the budget would otherwise end it.
    static constexpr float kLeastShare = 0.05F;

private:
    double m_seconds;
    double m_air = 0.0; ///< s a step, smoothed
    double m_perParticle = 0.0; ///< s, smoothed; 0: not known
    float m_share = 1.0F;
};

} // namespace fumage
