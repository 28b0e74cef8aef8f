#pragma once

#include <string>

namespace fumage {

/// The JSON Schema (draft 2020-12) of presets, derived from the parameter table.
[[nodiscard]] std::string presetSchema();

} // namespace fumage
