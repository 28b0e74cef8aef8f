#pragma once

#include "ui/document/search_index.h"

#include "core/effect/parameter.h"

#include <QString>

namespace fumage::ui {

// What the parameter table says, in the language of the user. The English texts of the table are the keys.

[[nodiscard]] QString labelOf(const Parameter& parameter);
[[nodiscard]] QString groupLabelOf(std::string_view group);
[[nodiscard]] QString choiceLabelOf(std::string_view choice);

/// A value as history and lists show it; empty where it needs a picture: colours, curves and gradients.
[[nodiscard]] QString valueTextOf(const Parameter& parameter, const Value& value);

/// "Motion: Wind angle", as undo steps and lists name a parameter outside of its panel.
[[nodiscard]] QString fullLabelOf(const Parameter& parameter);

/// All that a parameter is found by, in the language of the user and as it stands in the table.
[[nodiscard]] SearchTexts searchTextsOf(const Parameter& parameter);

/// What a parameter does, its unit, range, key and source, as rich text.
[[nodiscard]] QString toolTipOf(const Parameter& parameter);

} // namespace fumage::ui
