#pragma once

#include "core/lighting/light_field.h"
#include "core/lighting/lit_layer.h"
#include "core/rendering/sprite_batch.h"

namespace fumage {

/// Projects and lights every particle of a layer.
/// @param layer its effect is the look to apply
/// @param light that its layer is in, which knows its detail
/// @param surface with a texture
/// @param body  of where there is detail, see findBody(); else it is not looked at
/// O(particles). The same bits for any thread count and instruction set.
void makeSprites(const LitLayer& layer, const LightGrid& light, const SpriteSurface& surface,
    const AlignedArray<float>& body, const View& view, SpriteBatch& out);

} // namespace fumage
