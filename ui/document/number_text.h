#pragma once

#include "core/effect/parameter.h"

#include <QString>

#include <optional>

namespace fumage::ui {

/// A number as fields show it: five significant digits at most, no zeros behind.
[[nodiscard]] QString formatNumber(double value);

/// The same with the symbol of a unit: "3 m/s²", "90°".
[[nodiscard]] QString formatNumber(double value, Unit unit);

/// Reads what a person types: "1.5", "1,5", "150 cm", "0.5 rad", "50%"; the unit may be left out.
/// @param unit that the result is in
/// @return nothing where it is no finite number or the unit means something else
[[nodiscard]] std::optional<double> parseNumber(const QString& text, Unit unit);

} // namespace fumage::ui
