#pragma once

#include "core/effect/parameter.h"

#include <optional>

namespace fumage {

/// All parameters, in the order of panels and files: grouped, the most used first within a group.
[[nodiscard]] std::span<const Parameter> parameterTable();

/// @return the row with this key, or nullptr
[[nodiscard]] const Parameter* findParameter(std::string_view key);

/// @return the key with the smallest edit distance, for a former one that of its row today; empty when none is near
[[nodiscard]] std::string_view nearestParameterKey(std::string_view key);

/// @return the row that had this key in earlier versions of files, or nullptr
[[nodiscard]] const Parameter* findFormerParameter(std::string_view key);

/// The heading of a group: "emitter" gives "Emitter"; empty where there is none of this name.
[[nodiscard]] std::string_view groupLabel(std::string_view group);

/// Whose the parameters of a group are; nothing where there is none of this name.
[[nodiscard]] std::optional<Scope> groupScope(std::string_view group);

/// Whether the parameter has an influence as the effect stands (see VisibleWhen).
[[nodiscard]] bool isVisible(const Parameter& parameter, const Effect& effect);

} // namespace fumage
