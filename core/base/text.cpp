#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <vector>

#ifndef __cpp_lib_to_chars
#include <cerrno>
#include <clocale>
#include <cstdlib>
#ifdef __APPLE__
#include <xlocale.h>
#endif
#endif

namespace fumage {

namespace {

using std::from_chars;

#ifndef __cpp_lib_to_chars

/// As the library's, for those that have none of floats (libc++ before 20).
std::from_chars_result from_chars(const char* first, const char* last, float& value)
{
    static const locale_t s_plain = ::newlocale(LC_ALL_MASK, "C", nullptr);
    const std::string text(first, last);
    const bool isOther = text.empty() || std::string_view("+ \t\n\v\f\r").find(text.front()) != std::string_view::npos
        || text.find_first_of("xX") != std::string::npos;
    if (isOther) {
        return {first, std::errc::invalid_argument};
    }
    char* end = nullptr;
    errno = 0;
    value = ::strtof_l(text.c_str(), &end, s_plain);
    const bool fits = errno != ERANGE
        || (value != 0.0F && std::isfinite(value)); // those below the normal ones are said to be out of range, too
    return {first + (end - text.c_str()), fits ? std::errc{} : std::errc::result_out_of_range};
}
#endif

template <class T>
std::optional<T> parseWhole(std::string_view text)
{
    if (!text.empty() && text.front() == '+') {
        text.remove_prefix(1);
        if (!text.empty() && text.front() == '-') {
            return std::nullopt;
        }
    }
    T value{};
    const char* end = text.data() + text.size();
    const auto [stop, failure] = from_chars(text.data(), end, value);
    if (failure != std::errc{} || stop != end) {
        return std::nullopt;
    }
    return value;
}

std::size_t editDistance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0U : 1U);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row[b.size()];
}

bool isContinuation(char c)
{
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// Bytes of the UTF-8 character that a text begins with; 1 where it begins with none.
std::size_t characterLength(std::string_view text)
{
    constexpr std::array<unsigned char, 3> kLeadOfLength{0xC2, 0xE0, 0xF0}; // of 2, 3 and 4 bytes
    const auto lead = static_cast<unsigned char>(text.front());
    const auto length = static_cast<std::size_t>(
                            std::upper_bound(kLeadOfLength.begin(), kLeadOfLength.end(), lead) - kLeadOfLength.begin())
        + 1;
    const std::string_view rest = text.substr(1, length - 1);
    return rest.size() + 1 == length && std::all_of(rest.begin(), rest.end(), isContinuation) ? length : 1;
}

/// Whether a character is a control character (C0, DEL, C1), turns the direction of writing (U+202A to U+202E, U+2066
/// to U+2069), or is a stray byte.
bool steers(std::string_view character)
{
    const auto lead = static_cast<unsigned char>(character.front());
    if (character.size() == 1) {
        return lead < 0x20U || lead >= 0x7FU;
    }
    return (lead == 0xC2U && character[1] < '\xA0') || (character >= "\u202A" && character <= "\u202E")
        || (character >= "\u2066" && character <= "\u2069");
}

} // namespace

std::optional<float> parseFloat(std::string_view text)
{
    return parseWhole<float>(text);
}

std::optional<double> parseDouble(std::string_view text)
{
    return parseWhole<double>(text);
}

std::optional<std::int64_t> parseInteger(std::string_view text)
{
    return parseWhole<std::int64_t>(text);
}

namespace {

template <class Number>
std::string shortest(Number value)
{
    std::array<char, 64> buffer{};
    const auto [stop, failure] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), stop};
}

} // namespace

std::string formatFloat(float value)
{
    return shortest(value);
}

std::string formatDouble(double value)
{
    return shortest(value);
}

std::size_t splitCount(std::string_view text, char separator)
{
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), separator)) + 1;
}

std::string_view splitPart(std::string_view text, char separator, std::size_t index)
{
    for (; index > 0; --index) {
        const std::size_t at = text.find(separator);
        if (at == std::string_view::npos) {
            return {};
        }
        text.remove_prefix(at + 1);
    }
    return text.substr(0, text.find(separator));
}

std::optional<std::string_view> Parts::next()
{
    if (!m_rest) {
        return std::nullopt;
    }
    const std::size_t end = m_rest->find(m_separator);
    const std::string_view part = m_rest->substr(0, end);
    m_rest = end == std::string_view::npos ? std::nullopt : std::optional(m_rest->substr(end + 1));
    return part;
}

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kSpace = " \t\r\n";
    const std::size_t first = text.find_first_not_of(kSpace);
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::string inSmallLetters(std::string_view text)
{
    std::string small(text);
    std::transform(small.begin(), small.end(), small.begin(),
        [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return small;
}

std::string_view nearestName(std::string_view name, std::span<const std::string_view> candidates)
{
    constexpr std::size_t kLongestWorthComparing = 64;
    if (name.empty() || name.size() > kLongestWorthComparing) {
        return {};
    }
    std::string_view best;
    std::size_t bestDistance = name.size() / 2 + 1;
    for (const std::string_view candidate : candidates) {
        const std::size_t distance = editDistance(name, candidate);
        if (distance < bestDistance) {
            bestDistance = distance;
            best = candidate;
        }
    }
    return best;
}

bool isUtf8(std::string_view text)
{
    while (!text.empty()) {
        const std::string_view character = text.substr(0, characterLength(text));
        const auto lead = static_cast<unsigned char>(character.front());
        const bool isStray = character.size() == 1 && lead >= 0x80U;
        // Longer than it need be, half of a pair of UTF-16, and beyond the last character.
        const bool isForbidden = (character >= "\xE0\x80" && character < "\xE0\xA0")
            || (character >= "\xED\xA0" && character < "\xEE") || (character >= "\xF0\x80" && character < "\xF0\x90")
            || character >= "\xF4\x90";
        if (isStray || isForbidden) {
            return false;
        }
        text.remove_prefix(character.size());
    }
    return true;
}

std::string printable(std::string_view text)
{
    std::string out;
    while (!text.empty()) {
        const std::string_view character = text.substr(0, characterLength(text));
        const bool isSpace = character == "\n" || character == "\t";
        out += isSpace ? " " : steers(character) ? "?" : character;
        text.remove_prefix(character.size());
    }
    return out;
}

std::string inQuotes(std::string_view text)
{
    constexpr std::size_t kLongest = 60;
    std::size_t length = std::min(text.size(), kLongest);
    while (length > 0 && length < text.size() && isContinuation(text[length])) {
        --length;
    }
    return '"' + printable(text.substr(0, length)) + (text.size() > length ? "...\"" : "\"");
}

} // namespace fumage
