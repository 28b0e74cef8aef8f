#pragma once

#include "ui/preview/cost_estimate.h"
#include "ui/preview/running_simulators.h"

#include <memory>
#include <optional>

namespace fumage::ui {

/// Decides what a picture gives up to be there in time: particles, pixels, the grid of its air.
class PicturePlanner {
public:
    /// @param shelf for the air of what is simulated
    explicit PicturePlanner(const std::shared_ptr<AirCache>& shelf)
        : m_shelf(shelf)
        , m_simulators(shelf)
    {
    }

    [[nodiscard]] PicturePlan planFor(const RenderRequest& request);
    /// By which it decides: to be told what pictures have cost.
    [[nodiscard]] CostEstimate& costs() { return m_costs; }
    /// With which plans are simulated: what they have at hand costs nothing.
    [[nodiscard]] RunningSimulators& simulators() { return m_simulators; }

private:
    /// Whether coarser air has to stand in for the air of a plan.
    [[nodiscard]] bool lacksAir(const RenderRequest& request, const PicturePlan& plan, const Schedule& schedule) const;
    /// Whether all particles of a plan would be long in coming while frames are played.
    [[nodiscard]] bool isSlowToBegin(const RenderRequest& request, const PicturePlan& plan) const;
    /// Gives up pixels, so that a picture comes in time.
    void scaleDown(const RenderRequest& request, Quality quality, qint64 budgetNs, PicturePlan& plan) const;
    [[nodiscard]] int particlesWhileDragging(const PicturePlan& plan, double preRoll) const;
    /// Whether a plan has next to nothing to simulate.
    [[nodiscard]] bool isAtHand(const PicturePlan& plan) const;
    /// Draws as many of the particles that are there as a picture has time for.
    void drawWhatIsAffordable(PicturePlan& plan);
    [[nodiscard]] int particlesToSettle(int all, double preRoll) const;
    [[nodiscard]] int particlesToPlay(const PicturePlan& plan, double preRoll, double stepsAFrame) const;

    /// How many particles a drag draws of those that are there.
    struct Sparse {
        quint64 simulation = 0;
        int of = 0;
        int particles = 0;
    };

    std::shared_ptr<AirCache> m_shelf;
    RunningSimulators m_simulators;
    CostEstimate m_costs;
    std::optional<Sparse> m_sparse; ///< of the drag that goes on
};

} // namespace fumage::ui
