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
    /// Told now and then, on the thread that makes pictures, the share of the air that is baked; 1 when it is done or given up.
    using Baking = std::function<void(double share)>;

    /// @param shelf for the air of the effect, and its stand-in
    explicit Studio(
        std::shared_ptr<AirShelf> shelf = std::make_shared<AirShelf>(2), Baking baking = [](double) {});

    /// @return no picture where it was stopped, or where trouble() says why
    [[nodiscard]] PicturePtr make(const PictureRequest& request, const std::stop_token& stop);

    /// Why the last picture did not come; nothing where it did or was stopped.
    [[nodiscard]] const std::optional<Error>& trouble() const { return m_trouble; }

private:
    struct Plan {
        quint64 simulation = 0;
        SampledEffect effect; ///< thinned where need be
        double scale = 1.0;
        double stepsEach = 1.0;
        bool keepsAll = true; ///< particles
        bool coarseAir = false; ///< the air of a coarser grid stands in until there is time for its own
        bool settles = false; ///< see Haste::Settling
        bool complete = true; ///< and pixels
    };
    [[nodiscard]] Plan planFor(const PictureRequest& request) const;
    [[nodiscard]] bool bakeAir(const Plan& plan, int frame, Picture& picture, const std::stop_token& stop);
    void noteTrouble(const Error& error);
    [[nodiscard]] int particlesWhileDragging(const Plan& plan, double preRoll) const;
    [[nodiscard]] int particlesToSettle(int all, double preRoll) const;
    [[nodiscard]] std::shared_ptr<const Frame> simulate(const Plan& plan, int frame, const std::stop_token& stop);
    void addOverlays(const PictureRequest& request, const Plan& plan, Picture& picture, const std::stop_token& stop);
    [[nodiscard]] bool paint(const PictureRequest& request, const Plan& plan, Picture& picture, const std::stop_token& stop);
    [[nodiscard]] std::shared_ptr<const SpriteScene> collectSprites() const;
    [[nodiscard]] Simulator& simulatorFor(const Plan& plan);

    /// A simulator with what it was made for.
    struct Running {
        quint64 simulation = 0;
        int particles = 0;
        bool coarseAir = false;
        Simulator simulator;

        [[nodiscard]] bool isFor(const Plan& plan) const { return simulation == plan.simulation && particles == plan.effect->emitter.count && coarseAir == plan.coarseAir; }
    };
    std::shared_ptr<AirShelf> m_shelf;
    Baking m_baking;
    std::optional<Error> m_trouble;
    std::optional<Running> m_complete;
    std::optional<Running> m_thinned; ///< with fewer particles, while the hand drags
    std::optional<Running> m_settling; ///< with more of them, when it rests
    int m_lastFrame = -1;
    Renderer m_renderer;
    Image m_image;
    EncodedImage<std::uint8_t> m_encoded;
    CostEstimate m_costs;
};

} // namespace fumage::ui
