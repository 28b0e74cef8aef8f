#pragma once

#include <QStringView>

#include <optional>

namespace fumage::ui {

/// What a calculation at the beginning of a text comes to, and what stands behind it.
struct Calculation {
    double value = 0.0; ///< finite
    QStringView rest; ///< without blanks around it
};

/// What parts a number in the language of the user.
struct NumberSigns {
    QChar decimal = QLatin1Char('.');
    QChar group = QLatin1Char(','); ///< between thousands
    bool whole = false; ///< the number can have no fraction
};

/// Reads "3", "1,5", "2 * (3 + 4)", "-1/3 m": the four operations, brackets and signs, as on paper.
///
/// Point and comma are both decimal signs, in every language, as long as they cannot part thousands. Thousands are read
/// where they stand in groups of three: "1,000,000", "20 000", "1'000", "1.234,5". One sign before three digits, as in
/// "10,000", parts thousands where the number is whole, or where that is what the sign means in the language.
/// @return nothing where there is no number, its groups are none, a bracket is left open, or the result is not finite
[[nodiscard]] std::optional<Calculation> calculate(QStringView text, const NumberSigns& signs = {});

} // namespace fumage::ui
