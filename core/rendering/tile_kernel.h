#pragma once

#include "core/rendering/compositor.h"
#include "core/rendering/passes.h"

#include <array>
#include <span>

namespace fumage {

/// A tile while it is painted: rows of patches of 4 x 4 pixels, which cover a small disc with fewer vectors than rows of pixels do, and lie
/// on cache lines of their own.
struct Tile {
    static constexpr int kPatch = 4; ///< pixels along an edge of a patch
    static constexpr int kAcross = Compositor::kTileWidth / kPatch; ///< patches
    static constexpr int kDown = Compositor::kTileHeight / kPatch;
    static constexpr std::size_t kPatchPixels = static_cast<std::size_t>(kPatch) * kPatch;
    static constexpr std::size_t kPatchFloats = 4 * kPatchPixels;

    static constexpr std::size_t kPatchColours = 3 * kPatchPixels;
    static constexpr std::size_t kPatches = static_cast<std::size_t>(kAcross) * kDown;

    /// Of each patch: how much still shines through its pixels, row by row, then their premultiplied red, green and blue.
    alignas(64) std::array<float, kPatchFloats * kPatches> patches;
    RawArray<float> others; ///< of each patch: red, green and blue in the first of the other layers, then in the next
    int left = 0; ///< pixels of the image
    int top = 0;
    int right = 0; ///< exclusive
    int bottom = 0;
};

/// Paints sorted sprites into a tile, and writes the tile into the images of all layers. What makes a sprite's opacity is found once for all of them.
/// @param layers  at most kPassLayers
/// @param entries near to far
void paintTile(const SpriteBatch& batch, const SpriteTexture& texture, std::span<const Compositor::Layer> layers, std::span<const DepthEntry> entries, Tile& tile);

} // namespace fumage
