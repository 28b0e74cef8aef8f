#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace fumage {

/// Parses a whole text as a number: no locale, no leading or trailing characters.
/// @return nothing for an empty text, rubbish, or a value that does not fit; infinities and NaN are returned as such
[[nodiscard]] std::optional<float> parseFloat(std::string_view text);
/// As parseFloat(), for a double.
[[nodiscard]] std::optional<double> parseDouble(std::string_view text);
/// As parseFloat(), for a decimal whole number with an optional minus.
[[nodiscard]] std::optional<std::int64_t> parseInteger(std::string_view text);

/// The shortest decimal text that reads back as the same bits.
[[nodiscard]] std::string formatFloat(float value);

/// The same of a double.
[[nodiscard]] std::string formatDouble(double value);

/// Splits at every separator; "a,,b" has three parts, "" has one.
[[nodiscard]] std::size_t splitCount(std::string_view text, char separator);
/// @param index 0 to splitCount() - 1
/// @return that part of the text, without separators; a look into the text, which must outlive it
[[nodiscard]] std::string_view splitPart(std::string_view text, char separator, std::size_t index);

/// Goes through the parts of a text, as splitPart() has them, in one pass: the way through texts with many.
class Parts {
public:
    /// @param text which must outlive this
    Parts(std::string_view text, char separator)
        : m_rest(text)
        , m_separator(separator)
    {
    }
    /// @return the next part; none: that was the last one. O(part)
    [[nodiscard]] std::optional<std::string_view> next();

private:
    std::optional<std::string_view> m_rest; ///< from the next part on
    char m_separator;
};

/// @return the text without spaces, tabs and line ends at its ends; a look into it
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The text with A to Z as a to z; all other characters stay, whatever the locale.
[[nodiscard]] std::string inSmallLetters(std::string_view text);

/// The candidate with the smallest edit distance (Levenshtein), for "did you mean".
/// @return empty when nothing is near (more than half of the name's characters differ)
/// O(candidates * length^2).
[[nodiscard]] std::string_view nearestName(std::string_view name, std::span<const std::string_view> candidates);

/// Of enumerators that are counted from 0, the one that nameOf() calls so.
template <class Enum, std::size_t kCount>
[[nodiscard]] constexpr std::optional<Enum> enumeratorNamed(std::string_view name)
{
    for (std::size_t i = 0; i < kCount; ++i) {
        if (nameOf(static_cast<Enum>(i)) == name) {
            return static_cast<Enum>(i);
        }
    }
    return std::nullopt;
}

/// Whether a text is UTF-8 throughout: shortest forms, no surrogates, nothing beyond U+10FFFF.
[[nodiscard]] bool isUtf8(std::string_view text);

/// A text on one line without what would steer a terminal or turn the direction of writing: such characters, and bytes
/// that are not UTF-8, become '?', line breaks and tabs spaces.
[[nodiscard]] std::string printable(std::string_view text);

/// A bare name for a message: printable(), cut to 60 bytes at a character's border.
[[nodiscard]] std::string inQuotes(std::string_view text);

} // namespace fumage
