#pragma once

#include "core/rendering/compositor.h"

#include <array>
#include <span>

namespace fumage {

/// A tile while it is painted.
struct Tile {
    /// Rows are longer than the tile by a vector, which may run past the edge; what lies there is never read.
    static constexpr std::size_t kStride = static_cast<std::size_t>(Compositor::kTileWidth) + kAlignment / sizeof(float);
    /// Rows are painted in pairs, of which the second may lie below the edge: one more than the tile has.
    static constexpr std::size_t kPixels = kStride * static_cast<std::size_t>(Compositor::kTileHeight + 1);

    /// Four planes: how much still shines through, then premultiplied red, green and blue.
    alignas(64) std::array<float, 4 * kPixels> planes;
    int left = 0; ///< pixels of the image
    int top = 0;
    int right = 0; ///< exclusive
    int bottom = 0;
};

/// Paints sorted sprites into a tile that has been cleared, and writes the tile into the image.
/// @param entries near to far
void paintTile(const SpriteBatch& batch, const SpriteTexture& texture, std::span<const DepthEntry> entries, Tile& tile, Image& image);

} // namespace fumage
