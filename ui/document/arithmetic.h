#pragma once

#include <QStringView>

#include <optional>

namespace fumage::ui {

/// What a calculation at the beginning of a text comes to, and what stands behind it.
struct Calculation {
    double value = 0.0; ///< finite
    QStringView rest; ///< without blanks around it
};

/// Reads "3", "1,5", "2 * (3 + 4)", "-1/3 m": the four operations, brackets and signs, as on paper.
/// @return nothing where there is no number, a bracket is left open, or the result is no finite number
[[nodiscard]] std::optional<Calculation> calculate(QStringView text);

} // namespace fumage::ui
