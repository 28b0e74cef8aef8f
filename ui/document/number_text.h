#pragma once

#include "core/effect/parameter.h"

#include <QString>

#include <initializer_list>
#include <optional>

namespace fumage::ui {

/// A number as fields show it: five significant digits at most, no zeros behind, with the decimal sign of the language.
[[nodiscard]] QString formatNumber(double value);

/// Several, so that their decimal signs and what parts them are not mistaken for each other.
[[nodiscard]] QString formatNumbers(std::initializer_list<double> values);

/// The same with the symbol of a unit: "3 m/s²", "90°".
[[nodiscard]] QString formatNumber(double value, Unit unit);

/// Reads what a person types: "1.5", "1,5", "150 cm", "0.5 rad", "50%", "2 * (3 + 4)"; the unit may be left out.
/// @param unit that the result is in
/// @return nothing where it is no finite number or the unit means something else
[[nodiscard]] std::optional<double> parseNumber(const QString& text, Unit unit);

} // namespace fumage::ui
