#pragma once

#include "core/effect/parameter.h"
#include "core/effect/value.h"
#include "core/preset/json_tree.h"

#include <string_view>

namespace fumage {

/// What JSON says of a parameter.
/// @param text that the node is of, so that an error can show it
/// @error WrongType, and those of parseValue() and valueFromNumbers()
[[nodiscard]] Result<Clamped> valueOf(const Parameter& parameter, const JsonNode& node, std::string_view text);

} // namespace fumage
