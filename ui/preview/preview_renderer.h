#pragma once

#include "ui/preview/cost_estimate.h"
#include "ui/preview/picture.h"

#include "core/effect/sampling.h"
#include "core/rendering/renderer.h"
#include "core/rendering/view_transform.h"
#include "core/simulation/scene_simulator.h"

#include <functional>
#include <memory>
#include <optional>

namespace fumage::ui {

/// Makes pictures one after the other: keeps simulators, renderer and buffers from one to the next. For one thread.
class PreviewRenderer {
public:
    /// @param shelf for the air of the effect, and its stand-in
    explicit PreviewRenderer(
        std::shared_ptr<AirCache> shelf = std::make_shared<AirCache>(2), WorkListener listener = [](Phase, double) {});

    /// @return no picture where it was stopped, or where trouble() says why
    [[nodiscard]] PicturePtr make(const RenderRequest& request, const std::stop_token& stop);

    /// Why the last picture did not come; nothing where it did or was stopped.
    [[nodiscard]] const std::optional<Error>& trouble() const { return m_trouble; }

private:
    [[nodiscard]] PicturePtr makePicture(const RenderRequest& request, const std::stop_token& stop);

    struct Plan {
        quint64 simulation = 0;
        std::vector<SampledEffect> layers; ///< thinned where need be
        int particles = 0; ///< of all of them
        double scale = 1.0;
        double stepsEach = 1.0;
        bool keepsAll = true; ///< particles
        bool coarseAir = false; ///< the air of a coarser grid stands in until there is time for its own
        bool settles = false; ///< particles as few as come soon, see PreviewQuality::Intermediate
        PhaseMix phaseMix = PhaseMix::Blend;
        bool complete = true; ///< and pixels, and both phases of the detail
    };
    [[nodiscard]] Plan planFor(const RenderRequest& request) const;
    struct Running;
    /// Whether coarser air has to stand in for the air of a plan.
    [[nodiscard]] bool lacksAir(const RenderRequest& request, const Plan& plan, const Schedule& schedule) const;
    /// Whether all particles of a plan would be long in coming while frames are played.
    [[nodiscard]] bool isSlowToBegin(const RenderRequest& request, const Plan& plan, double preRoll) const;
    [[nodiscard]] static double stepsTo(
        int frame, const std::optional<Running>& running, const Plan& plan, const Schedule& schedule, double preRoll);
    /// Gives up pixels, so that a picture comes in time.
    void scaleDown(const RenderRequest& request, Quality quality, Plan& plan) const;
    void takePrepared(const RenderRequest& request, const Plan& plan);
    [[nodiscard]] bool bakeAir(const Plan& plan, int frame, Picture& picture, const std::stop_token& stop);
    void noteTrouble(const Error& error);
    [[nodiscard]] int particlesWhileDragging(const Plan& plan, double preRoll) const;
    [[nodiscard]] int particlesToSettle(int all, double preRoll) const;
    [[nodiscard]] int particlesToPlay(const Plan& plan, double preRoll, double stepsAFrame) const;
    [[nodiscard]] std::optional<SceneFrame> simulate(const Plan& plan, int frame, const std::stop_token& stop);
    void addOverlays(const RenderRequest& request, const Plan& plan, Picture& picture, const std::stop_token& stop);
    [[nodiscard]] bool paint(
        const RenderRequest& request, const Plan& plan, Picture& picture, const std::stop_token& stop);
    [[nodiscard]] Running& runningFor(const Plan& plan);

    /// A simulator with what it was made for.
    struct Running {
        quint64 simulation = 0;
        int particles = 0;
        bool coarseAir = false;
        SceneSimulator simulator;
        std::optional<int> lastFrame{}; ///< that it was asked for

        [[nodiscard]] bool isFor(const Plan& plan) const
        {
            return simulation == plan.simulation && particles == plan.particles && coarseAir == plan.coarseAir;
        }
    };
    std::shared_ptr<AirCache> m_shelf;
    WorkListener m_listener;
    std::optional<Error> m_trouble;
    std::optional<Running> m_complete;
    std::optional<Running> m_thinned; ///< with fewer particles, while the hand drags
    std::optional<Running> m_settling; ///< with more of them, when it rests or is played before all are there
    Renderer m_renderer;
    Image m_image;
    EncodedImage<std::uint8_t> m_encoded;
    CostEstimate m_costs;
};

} // namespace fumage::ui
