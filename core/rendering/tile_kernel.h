#pragma once

#include "core/rendering/depth_sort.h"
#include "core/rendering/tile.h"

#include <span>

namespace fumage {

/// Paints sorted sprites into a tile, and writes the tile into the images of all targets. What makes a sprite's opacity
/// is found once for all of them.
/// @param layers   one or more
/// @param targets  at most kPassTargets
/// @param entries near to far, their indices the bits of SpriteNumber
void paintTile(
    SpriteLayers layers, std::span<const RenderTarget> targets, std::span<const DepthEntry> entries, Tile& tile);

} // namespace fumage
