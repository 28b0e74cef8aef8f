#pragma once

#include "core/base/result.h"
#include "core/export/sheets/flipbook_options.h"
#include "core/scene/scene.h"

namespace fumage {

/// Whether the sheets of layers may hold what is asked for.
/// @error OutOfRange where shares of layers are to have other passes than colour and alpha, or packed pictures, and
/// where a sheet of one layer is to have the masks of all
[[nodiscard]] Status checkLayers(const FlipbookOptions& options);

/// Whether a flipbook of a scene can be made.
/// @error OutOfRange; NotUtf8; TooLarge before anything is allocated
[[nodiscard]] Status checkFlipbook(const Scene& scene, const FlipbookOptions& options);

} // namespace fumage
