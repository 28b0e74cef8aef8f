#pragma once

#include "ui/preview/picture.h"

namespace fumage::ui {

/// Which layer of the scene is seen at a place, by the sprites that a renderer has.
/// @param layers of the scene, in the order in which the renderer has them
[[nodiscard]] Picked layerSeenAt(const Pick& pick, const Renderer& renderer, const std::vector<std::size_t>& layers);

} // namespace fumage::ui
