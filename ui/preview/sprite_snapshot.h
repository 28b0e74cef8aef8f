#pragma once

#include "core/rendering/renderer.h"

#include <memory>
#include <vector>

namespace fumage::ui {

/// Sprites for a graphics card: far to near, with all that they need.
struct SpriteBatchSnapshot {
    /// Sprites that follow one another and show the same, or nothing.
    struct Run {
        std::size_t first = 0;
        std::size_t count = 0;
        std::size_t surface = 0; ///< its place in surfaces
    };
    std::vector<Sprite> sprites;
    std::vector<SpriteDetail> details; ///< of the sprites; empty where the smoke has none
    std::vector<std::uint32_t> layers; ///< of the sprites, places in styles
    std::vector<SpriteStyle> styles; ///< of each layer
    std::vector<SpriteSurface> surfaces; ///< of all layers, each once; where there is a picture without the noise
    std::vector<Run> runs;
    View view;
};

/// The sprites that a renderer has prepared, of all its layers.
[[nodiscard]] std::shared_ptr<const SpriteBatchSnapshot> snapshotOf(const Renderer& renderer);

} // namespace fumage::ui
