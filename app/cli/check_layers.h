#pragma once

#include "core/base/result.h"
#include "core/export/sheets/layer_check.h"

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace fumage::cli {

/// The sheets of layers that a person names by their manifest, or by one of them; nothing where the name is that of a
/// preset.
/// @error those of findLayeredSheets()
[[nodiscard]] Result<std::optional<LayeredSheets>> layeredSheetsNamed(const std::string& name);

/// Scores them, with a bar of progress, and prints what comes of it.
/// @param name   as the user named them
/// @param answer gets it where it is to be JSON; null: it is printed
/// @error those of scoreLayers()
[[nodiscard]] Status checkLayers(const std::string& name, const LayeredSheets& layered, nlohmann::ordered_json* answer);

} // namespace fumage::cli
