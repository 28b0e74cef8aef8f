#pragma once

#include "core/lighting/detail_field.h"
#include "core/lighting/light_grid.h"
#include "core/rendering/sprite_batch.h"

namespace fumage {

/// Projects and lights every particle.
/// @param effect the look to apply
/// @param detail that the air carries, and the light knows; null: none
/// O(particles). The same bits for any thread count and instruction set.
void makeSprites(const Frame& frame, const SampledEffect& effect, const Appearance& appearance, const LightGrid& light,
    const SpriteTexture& texture, const DetailField* detail, const View& view, SpriteBatch& out);

} // namespace fumage
