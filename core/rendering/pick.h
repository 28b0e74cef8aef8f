#pragma once

#include "core/base/result.h"
#include "core/rendering/sprite_batch.h"

#include <optional>

namespace fumage {

/// Which layer is seen most at a pixel: the one whose sprites send most light from there, or hide most of what is
/// behind them, as far as those before them let them.
/// @param layers as they are drawn together
/// @param x,y    pixel, from the left and from the top; with those around it, since nobody aims better
/// @return its place among the layers; none: nothing is seen there
/// O(sprites), about 1 ms for a million.
[[nodiscard]] std::optional<std::size_t> layerAt(SpriteLayers layers, int x, int y);

} // namespace fumage
