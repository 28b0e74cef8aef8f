#pragma once

#include "ui/preview/picture_planner.h"
#include "ui/preview/running_simulators.h"

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
    /// The last picture, where a request asks for nothing more than what is seen in it; null: it asks for another.
    [[nodiscard]] PicturePtr lastPicked(const RenderRequest& request) const;

    using Plan = PicturePlan;
    void takePrepared(const RenderRequest& request, const Plan& plan);
    [[nodiscard]] bool bakeAir(const Plan& plan, int frame, Picture& picture, const std::stop_token& stop);
    void noteTrouble(const Error& error);
    [[nodiscard]] std::optional<SceneFrame> simulate(const Plan& plan, int frame, const std::stop_token& stop);
    [[nodiscard]] std::vector<LayerWork> workOf(const RenderRequest& request, const Plan& plan);
    [[nodiscard]] Status prepare(
        const RenderRequest& request, const Plan& plan, const SceneFrame& frame, const std::stop_token& stop);
    void addOverlays(const RenderRequest& request, const Plan& plan, Picture& picture, const std::stop_token& stop);
    [[nodiscard]] bool paint(
        const RenderRequest& request, const Plan& plan, Picture& picture, const std::stop_token& stop);

    std::shared_ptr<AirCache> m_shelf;
    WorkListener m_listener;
    std::optional<Error> m_trouble;
    PicturePlanner m_planner;
    Renderer m_renderer;
    PicturePtr m_last; ///< of the sprites that the renderer has; null: it has none
    std::vector<std::size_t> m_drawn; ///< layers of the scene that they are of, in the renderer's order
    Image m_image;
    EncodedImage<std::uint8_t> m_encoded;
};

} // namespace fumage::ui
