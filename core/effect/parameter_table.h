#pragma once

#include "core/effect/parameter.h"

namespace fumage {

/// All parameters, in the order of panels and files: grouped, the most used first within a group.
[[nodiscard]] std::span<const Parameter> parameterTable();

/// @return the row with this key, or nullptr
[[nodiscard]] const Parameter* findParameter(std::string_view key);

/// @return the known key with the smallest edit distance; empty when none is near
[[nodiscard]] std::string_view nearestParameterKey(std::string_view key);

/// The heading of a group: "emitter" gives "Emitter".
[[nodiscard]] std::string_view groupLabel(std::string_view group);

/// Whether the parameter has an influence as the effect stands (see VisibleWhen).
[[nodiscard]] bool isVisible(const Parameter& parameter, const Effect& effect);

} // namespace fumage
