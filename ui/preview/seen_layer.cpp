#include "ui/preview/seen_layer.h"

#include "core/rendering/pick.h"

#include <algorithm>

namespace fumage::ui {

Picked layerSeenAt(const Pick& pick, const Renderer& renderer, const std::vector<std::size_t>& layers)
{
    if (pick.number == 0) {
        return {};
    }
    const View& view = renderer.batch().view;
    const auto pixel = [](float share, int pixels) {
        return std::clamp(static_cast<int>(share * static_cast<float>(pixels)), 0, pixels - 1);
    };
    const std::optional<std::size_t> layer =
        layerAt(renderer.layers(), pixel(pick.place.x, view.width), pixel(pick.place.y, view.height));
    return {pick.number, layer && *layer < layers.size() ? std::optional(layers[*layer]) : std::nullopt};
}

} // namespace fumage::ui
