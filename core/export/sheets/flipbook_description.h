#pragma once

#include "core/export/sheets/flipbook_options.h"
#include "core/scene/scene.h"

#include <string>

namespace fumage {

/// What stands in the file beside a flipbook: JSON that says how it is played, and of each picture which pass it holds,
/// in which channels and how its numbers are read.
[[nodiscard]] std::string describeFlipbook(
    const Scene& scene, const FlipbookOptions& options, const Flipbook& flipbook, const PassScales& scales);

} // namespace fumage
