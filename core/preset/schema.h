#pragma once

#include <string>

namespace fumage {

/// The JSON Schema (draft 2020-12) of presets, derived from the parameter table. It refuses unknown keys, which the
/// reader only warns of, so that editors of text show typing errors.
[[nodiscard]] std::string presetSchema();

} // namespace fumage
