#pragma once

#include "ui/preview/picture_plan.h"

#include "core/simulation/scene_simulator.h"

#include <array>
#include <memory>
#include <optional>

namespace fumage::ui {

/// A simulator of a scene with what it was made for.
struct RunningSimulator {
    quint64 simulation = 0;
    int particles = 0;
    bool coarseAir = false;
    SceneSimulator simulator;
    bool hasBegun = false; ///< it has given a frame

    [[nodiscard]] bool isFor(const PicturePlan& plan) const
    {
        return simulation == plan.simulation && particles == plan.particles && coarseAir == plan.coarseAir;
    }
    /// Steps that the particles of its layers have to take to a frame, on average.
    [[nodiscard]] double stepsEach(int frame) const;
};

/// The simulators of one scene that pictures of it are made with: of all its particles, and of fewer. What a change
/// leaves as it was goes on where it is.
class RunningSimulators {
public:
    /// @param shelf for their air
    explicit RunningSimulators(std::shared_ptr<AirCache> shelf)
        : m_shelf(std::move(shelf))
    {
    }

    /// With all particles; null: none is there for this plan.
    [[nodiscard]] const RunningSimulator* complete(const PicturePlan& plan) const;
    /// With fewer, while the hand drags.
    [[nodiscard]] const std::optional<RunningSimulator>& thinned() const { return m_all[Thinned]; }
    /// With more of them, when it rests or is played before all are there.
    [[nodiscard]] const std::optional<RunningSimulator>& settling() const { return m_all[Settling]; }
    /// The one that a plan is simulated with, made where it is not there.
    [[nodiscard]] RunningSimulator& runningFor(const PicturePlan& plan);
    /// Takes what a change of the scene leaves as it was over into a simulator of all particles of the scene as it is:
    /// then it is known what there is to do.
    void renew(const PicturePlan& plan);
    /// Takes one that others have brought to a frame, with all particles.
    void take(const PicturePlan& plan, SceneSimulator simulator);
    /// Steps that the particles of a plan have to take to a frame, on average.
    /// @param preRoll of those that are not there
    [[nodiscard]] double stepsEach(const PicturePlan& plan, int frame, double preRoll) const;

private:
    enum Place {
        Complete,
        Thinned,
        Settling
    };
    [[nodiscard]] static Place placeFor(const PicturePlan& plan);
    [[nodiscard]] RunningSimulator made(const PicturePlan& plan, std::optional<RunningSimulator>& before) const;

    std::shared_ptr<AirCache> m_shelf;
    std::array<std::optional<RunningSimulator>, 3> m_all; ///< by their place
};

} // namespace fumage::ui
