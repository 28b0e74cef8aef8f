#pragma once

#include "ui/preview/picture.h"

namespace fumage::ui {

/// What the work has cost so far, to foretell what the next picture will cost. All in nanoseconds, smoothed over some
/// pictures.
class CostEstimate {
public:
    static constexpr double kSmallestScale = 0.35;
    /// With fewer of them smoke is a blur that tells nothing, however slow the machine is.
    static constexpr int kMinParticles = 4000;

    void noteSteps(double particleSteps, qint64 ns);
    void noteSprites(int particles, qint64 ns);
    void notePixels(double pixels, qint64 ns);

    /// @return how many particles can be stepped and drawn within a budget; at least kMinParticles
    /// @param stepsEach steps that each has to take, on average
    /// @param drawnShare share of them that is drawn
    [[nodiscard]] int particlesWithin(qint64 ns, double stepsEach, double drawnShare = 1.0) const;

    /// @return share of the picture's edge, from 1 down to kSmallestScale, that can be painted within what particles
    /// leave of a budget
    [[nodiscard]] double scaleWithin(
        qint64 ns, int particles, double stepsEach, double pixels, double drawnShare = 1.0) const;

    /// @return a count that is halved until it is affordable, but no more often than leaves kMinParticles
    [[nodiscard]] static int halvedInto(int count, int affordable);

private:
    double m_step = 10.0; ///< a particle and step
    double m_sprite = 150.0; ///< a particle: light, sprite, binning
    double m_pixel = 40.0; ///< a pixel of the picture
};

} // namespace fumage::ui
