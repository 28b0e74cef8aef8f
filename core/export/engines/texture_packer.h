#pragma once

#include "core/export/engines/engine_sheet.h"

namespace fumage {

/// TexturePacker's "JSON (Hash)", which PixiJS, Phaser, Babylon and libGDX read: cells by name, and their order.
[[nodiscard]] std::string texturePackerText(const EngineSheet& sheet);

} // namespace fumage
