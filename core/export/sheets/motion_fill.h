#pragma once

#include "core/rendering/image.h"

namespace fumage {

/// Divides the channels of a picture of cells by alpha, and goes on with them where there is hardly any smoke: what
/// engines read beside the smoke, because it moves or because they filter, is then that of the smoke next to it. Pull
/// and push (Gortler and others, "The Lumigraph", SIGGRAPH 1996): blocks of twice the size until there is smoke enough,
/// bilinear between them. Nothing leaves its cell; cells without smoke are 0.
/// @param image  premultiplied; becomes straight channels, and the alpha as it was
/// @param enough alpha from which on a pixel is taken as it is, more than 0
/// O(pixels). The same bits for any thread count.
void straighten(Image& image, int cellWidth, int cellHeight, float enough);

} // namespace fumage
