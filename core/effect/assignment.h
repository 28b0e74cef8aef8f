#pragma once

#include "core/base/result.h"
#include "core/effect/effect.h"

#include <string_view>

namespace fumage {

/// Parses "key=value" and applies it, as --set does.
/// @return whether the value had to be clamped
/// @error UnknownKey with the nearest name; those of parseValue()
[[nodiscard]] Result<bool> applyAssignment(Effect& effect, std::string_view assignment);

/// There is no parameter of this key; which one may have been meant.
[[nodiscard]] Error noParameter(std::string_view key);

} // namespace fumage
