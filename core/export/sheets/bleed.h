#pragma once

#include "core/rendering/view_transform.h"

namespace fumage {

/// Gives transparent pixels the colour of those around them, weighted by alpha: next to others the mean of these, which
/// is what filtering mixes; farther away that of the smallest block that has any, up to the whole cell, which is what
/// mipmaps mix (pull and push; Gortler and others, "The Lumigraph", SIGGRAPH 1996). Alpha stays. An empty cell stays as
/// it is.
/// @param cellWidth,cellHeight the picture is divided into these, and no colour leaves its cell
/// O(pixels).
void bleedColours(EncodedImage<std::uint8_t>& image, int cellWidth, int cellHeight);
/// The same in 16 bits.
void bleedColours(EncodedImage<std::uint16_t>& image, int cellWidth, int cellHeight);

} // namespace fumage
