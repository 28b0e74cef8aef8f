#pragma once

#include "core/base/aligned_array.h"
#include "core/rendering/image.h"
#include "core/rendering/sprite_batch.h"

#include <array>
#include <cstddef>
#include <limits>

namespace fumage {

/// A picture to compose.
struct RenderTarget {
    static constexpr std::size_t kAllLayers = std::numeric_limits<std::size_t>::max();

    const SpriteTarget* colours = nullptr; ///< one a layer, all of the same light; null: the sprites' own
    Image* image = nullptr; ///< resized; every pixel is written
    /// Of the sprites' own colours: what the first so many layers give, the others hiding what they hide without any
    /// colour; alpha is what those layers cover. Of all layers it is the picture, to the bit.
    std::size_t firstLayers = kAllLayers;

    /// Whether it is the picture itself.
    [[nodiscard]] bool isWhole() const { return colours == nullptr && firstLayers == kAllLayers; }
};

/// A tile while it is painted: rows of patches of 4 x 4 pixels, which cover a small disc with fewer vectors than rows
/// of pixels do, and lie on cache lines of their own.
struct Tile {
    static constexpr int kWidth = 64; ///< pixels
    static constexpr int kHeight = 64;
    static constexpr int kPatch = 4; ///< pixels along an edge of a patch
    static constexpr int kAcross = kWidth / kPatch; ///< patches
    static constexpr int kDown = kHeight / kPatch;
    static constexpr std::size_t kPatchPixels = static_cast<std::size_t>(kPatch) * kPatch;
    static constexpr std::size_t kPatchFloats = 4 * kPatchPixels;

    static constexpr std::size_t kPatches = static_cast<std::size_t>(kAcross) * kDown;

    /// Of each patch: how much still shines through its pixels, row by row, then their premultiplied red, green and
    /// blue.
    alignas(64) std::array<float, kPatchFloats * kPatches> patches;
    RawArray<float> others; ///< of each patch: the same in the first of the other targets, then in the next; what
                            ///< shines through is counted only by those of some layers
    int left = 0; ///< pixels of the image
    int top = 0;
    int right = 0; ///< exclusive
    int bottom = 0;
};

} // namespace fumage
