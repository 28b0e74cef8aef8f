#pragma once

#include "core/effect/parameter.h"

#include <vector>

namespace fumage {

// The table as people look at it: in panels, search and help. Beside the parameters that an effect holds there are
// derived ones, which write another. Files know nothing of them.

/// All rows: those of the table and the derived ones, in the order of panels, group by group.
[[nodiscard]] const std::vector<const Parameter*>& shownParameters();

/// @return the row of the table or the derived one with this key, or nullptr
[[nodiscard]] const Parameter* findShownParameter(std::string_view key);

/// The parameter of the table that setting a row changes: itself, unless it is derived.
[[nodiscard]] const Parameter& storedParameter(const Parameter& shown);

/// What the stored parameter has to be for a row to have a value.
[[nodiscard]] Value storedValue(const Parameter& shown, const Value& value, const Effect& effect);

} // namespace fumage
