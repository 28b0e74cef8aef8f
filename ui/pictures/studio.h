#pragma once

#include "ui/pictures/haste.h"
#include "ui/pictures/picture.h"

#include "core/rendering/view_transform.h"
#include "core/simulation/simulator.h"

#include <optional>

namespace fumage::ui {

/// Makes pictures one after the other: keeps simulators, renderer and buffers from one to the next. For one thread.
class Studio {
public:
    /// @return no picture where it was stopped or is too large
    [[nodiscard]] PicturePtr make(const PictureRequest& request, const std::stop_token& stop);

private:
    struct Plan {
        Effect effect;
        double scale = 1.0;
        double stepsEach = 1.0;
        bool keepsAll = true; ///< particles
        bool complete = true; ///< and pixels
    };
    [[nodiscard]] Plan planFor(const PictureRequest& request) const;
    [[nodiscard]] int particlesWhileDragging(const Effect& effect, double stepsEach, double preRoll) const;
    [[nodiscard]] std::shared_ptr<const Frame> simulate(const Plan& plan, int frame, const std::stop_token& stop);
    [[nodiscard]] bool paint(const PictureRequest& request, const Plan& plan, Picture& picture, const std::stop_token& stop);
    [[nodiscard]] std::shared_ptr<const SpriteScene> collectSprites() const;
    [[nodiscard]] Simulator& simulatorFor(const Effect& effect, bool complete);

    /// A simulator with the effect that it was made for: one for all particles, one for fewer while the hand drags.
    struct Running {
        Effect effect;
        Simulator simulator;
    };
    std::optional<Running> m_complete;
    std::optional<Running> m_thinned;
    int m_lastFrame = -1;
    Renderer m_renderer;
    Image m_image;
    EncodedImage<std::uint8_t> m_encoded;
    CostEstimate m_costs;
};

/// Whether two effects have the same particles at every frame.
[[nodiscard]] bool simulateAlike(const Effect& a, const Effect& b);

} // namespace fumage::ui
