#pragma once

#include "core/effect/parameter.h"

#include <QString>

#include <initializer_list>
#include <optional>

namespace fumage::ui {

inline constexpr int kShownDigits = 5; ///< significant ones

/// A number as fields show it: so many significant digits at most, no zeros behind, with the decimal sign of the
/// language.
[[nodiscard]] QString formatNumber(double value, int digits = kShownDigits);

/// With so many digits behind the decimal sign, for what changes while one looks at it.
[[nodiscard]] QString formatFixed(double value, int decimals);

/// Several, so that their decimal signs and what parts them are not mistaken for each other.
[[nodiscard]] QString formatNumbers(std::initializer_list<double> values);

/// The same with the symbol of a unit: "3 m/s²", "90°".
[[nodiscard]] QString formatNumber(double value, Unit unit, int digits = kShownDigits);

/// Reads what a person types: "1.5", "1,5", "150 cm", "0.5 rad", "50%", "2 * (3 + 4)"; the unit may be left out.
/// Thousands may be parted; see calculate().
/// @param unit  that the result is in
/// @param whole it can have no fraction: one sign before three digits parts thousands then
/// @return nothing where it is no finite number or the unit means something else
[[nodiscard]] std::optional<double> parseNumber(const QString& text, Unit unit, bool whole = false);

} // namespace fumage::ui
