#pragma once

#include "ui/pictures/haste.h"
#include "ui/pictures/picture.h"

#include "core/effect/sampling.h"
#include "core/rendering/view_transform.h"
#include "core/simulation/simulator.h"

#include <functional>
#include <memory>
#include <optional>

namespace fumage::ui {

/// Makes pictures one after the other: keeps simulators, renderer and buffers from one to the next. For one thread.
class Studio {
public:
    /// @param shelf for the air of the effect, and its stand-in
    explicit Studio(
        std::shared_ptr<AirShelf> shelf = std::make_shared<AirShelf>(2), WorkListener listener = [](Phase, double) {});

    /// @return no picture where it was stopped, or where trouble() says why
    [[nodiscard]] PicturePtr make(const PictureRequest& request, const std::stop_token& stop);

    /// Why the last picture did not come; nothing where it did or was stopped.
    [[nodiscard]] const std::optional<Error>& trouble() const { return m_trouble; }

private:
    [[nodiscard]] PicturePtr makePicture(const PictureRequest& request, const std::stop_token& stop);

    struct Plan {
        quint64 simulation = 0;
        SampledEffect effect; ///< thinned where need be
        double scale = 1.0;
        double stepsEach = 1.0;
        bool keepsAll = true; ///< particles
        bool coarseAir = false; ///< the air of a coarser grid stands in until there is time for its own
        bool settles = false; ///< particles as few as come soon, see Haste::Settling
        bool complete = true; ///< and pixels
    };
    [[nodiscard]] Plan planFor(const PictureRequest& request) const;
    struct Running;
    /// Whether coarser air has to stand in for the air of a plan.
    [[nodiscard]] bool lacksAir(const PictureRequest& request, const Plan& plan, const Schedule& schedule) const;
    /// Whether all particles of a plan would be long in coming while frames are played.
    [[nodiscard]] bool isSlowToBegin(const PictureRequest& request, const Plan& plan, double preRoll) const;
    [[nodiscard]] static double stepsTo(int frame, const std::optional<Running>& running, const Plan& plan, const Schedule& schedule, double preRoll);
    /// Gives up pixels, so that a picture comes in time.
    void scaleDown(const PictureRequest& request, Quality quality, Plan& plan) const;
    void takePrepared(const PictureRequest& request, const Plan& plan);
    [[nodiscard]] bool bakeAir(const Plan& plan, int frame, Picture& picture, const std::stop_token& stop);
    void noteTrouble(const Error& error);
    [[nodiscard]] int particlesWhileDragging(const Plan& plan, double preRoll) const;
    [[nodiscard]] int particlesToSettle(int all, double preRoll) const;
    [[nodiscard]] int particlesToPlay(const Plan& plan, double preRoll, double stepsAFrame) const;
    [[nodiscard]] std::shared_ptr<const Frame> simulate(const Plan& plan, int frame, const std::stop_token& stop);
    void addOverlays(const PictureRequest& request, const Plan& plan, Picture& picture, const std::stop_token& stop);
    [[nodiscard]] bool paint(const PictureRequest& request, const Plan& plan, Picture& picture, const std::stop_token& stop);
    [[nodiscard]] std::shared_ptr<const SpriteScene> collectSprites() const;
    [[nodiscard]] Running& runningFor(const Plan& plan);

    /// A simulator with what it was made for.
    struct Running {
        quint64 simulation = 0;
        int particles = 0;
        bool coarseAir = false;
        Simulator simulator;
        std::optional<int> lastFrame{}; ///< that it was asked for

        [[nodiscard]] bool isFor(const Plan& plan) const { return simulation == plan.simulation && particles == plan.effect->emitter.count && coarseAir == plan.coarseAir; }
    };
    std::shared_ptr<AirShelf> m_shelf;
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
