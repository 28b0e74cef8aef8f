#pragma once

#include "core/base/result.h"
#include "core/export/engines/engine.h"
#include "core/export/engines/engine_sheet.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace fumage {

/// The files that make an engine play a flipbook.
/// @param named    the picture after which they are named
/// @param pictures those of the flipbook; the first is the colour's
[[nodiscard]] std::vector<std::filesystem::path> engineFilesOf(
    Engine engine, const std::filesystem::path& named, std::span<const std::filesystem::path> pictures);

/// What stands in them, in the same order.
[[nodiscard]] std::vector<std::string> makeEngineFiles(Engine engine, const EngineSheet& sheet);

/// Whether what is written for an engine draws layers over one another: it must blend premultiplied colours.
[[nodiscard]] bool stacksLayers(Engine engine);

/// Whether an engine takes such pictures.
/// @error OutOfRange, with what to choose
[[nodiscard]] Status checkEngine(Engine engine, PassSet passes, ImageFormat format);

} // namespace fumage
