#pragma once

#include "core/base/result.h"
#include "core/effect/parameter.h"

#include <string>
#include <vector>

namespace fumage {

/// @return the value as canonical text, which is also its JSON: numbers shortest round trip, names in double quotes
[[nodiscard]] std::string formatJson(const Parameter& parameter, const Value& value);

/// @return the value as a person types it: formatJson() without quotes. Where withUnit, as one reads it: with its unit,
/// and of a picture its size
[[nodiscard]] std::string formatText(const Parameter& parameter, const Value& value, bool withUnit = false);

struct Clamped {
    Value value;
    bool changed = false; ///< it was outside of what the type or the parameter allows; a direction may have any length
};

/// Reads what formatText() writes; brackets around a vector may be left out. Only what the type cannot hold is clamped:
/// see clampValue(). A picture is its PNG in base64; nothing: none.
/// @error WrongType, NotFinite, UnknownName, those of Bitmap::read(); the place is the key
[[nodiscard]] Result<Clamped> parseValue(const Parameter& parameter, std::string_view text);

/// Checks numbers that were read for a parameter and packs them.
/// @param numbers Float, Int, Seed, Bool: 1; Direction, Vector, Colour: 3; Curve: 2 a point; Gradient: 4 a stop
/// @error WrongType for a wrong count or a fraction where a whole number is meant; NotFinite
[[nodiscard]] Result<Clamped> valueFromNumbers(const Parameter& parameter, std::span<const double> numbers);

/// Brings every component into the hard range, a direction to unit length (a zero one to the default's), points in
/// order.
/// @param value finite
[[nodiscard]] Clamped clampValue(const Parameter& parameter, const Value& value);

/// @return the rows in which two effects differ, in table order
[[nodiscard]] std::vector<const Parameter*> differences(const Effect& a, const Effect& b);

/// Clamps and writes. @return whether the value had to be clamped, here or when it was read
bool setClamped(Effect& effect, const Parameter& parameter, const Value& value);
bool setClamped(Effect& effect, const Parameter& parameter, const Clamped& read);

} // namespace fumage
