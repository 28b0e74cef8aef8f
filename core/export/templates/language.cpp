#include "core/export/templates/language.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace fumage {

namespace {

constexpr char32_t kReplacement = 0xFFFD;

/// Takes the first character of a text; U+FFFD for a byte that begins none. Source: Unicode 15, table 3-7.
char32_t takeCharacter(std::string_view& text)
{
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
    const std::uint32_t lead = byte(0);
    const std::size_t length = lead < 0x80 ? 1
        : lead >= 0xC2 && lead < 0xE0      ? 2
        : lead >= 0xE0 && lead < 0xF0      ? 3
        : lead >= 0xF0 && lead < 0xF5      ? 4
                                           : 0;
    char32_t value = length == 1 ? lead : lead & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        value = follows(i) ? value << 6U | (byte(i) & 0x3FU) : 0x110000;
        if (value >= 0x110000) {
            break;
        }
    }
    constexpr std::array<char32_t, 5> kMin{0, 0, 0x80, 0x800, 0x10000};
    const bool isWhole = length > 0 && value < 0x110000 && value >= kMin[length] && (value < 0xD800 || value > 0xDFFF);
    text.remove_prefix(isWhole ? length : 1);
    return isWhole ? value : kReplacement;
}

std::string utf8(char32_t c)
{
    const auto tail = [&](unsigned shift) { return static_cast<char>(0x80U | (c >> shift & 0x3FU)); };
    if (c < 0x80) {
        return {static_cast<char>(c)};
    }
    if (c < 0x800) {
        return {static_cast<char>(0xC0U | c >> 6U), tail(0)};
    }
    if (c < 0x10000) {
        return {static_cast<char>(0xE0U | c >> 12U), tail(6), tail(0)};
    }
    return {static_cast<char>(0xF0U | c >> 18U), tail(12), tail(6), tail(0)};
}

std::string digits(char32_t value, unsigned base, std::size_t count)
{
    std::string out(count, '0');
    for (auto digit = out.rbegin(); digit != out.rend() && value > 0; ++digit, value /= base) {
        *digit = "0123456789abcdef"[value % base];
    }
    return out;
}

bool isPrintableAscii(char32_t c)
{
    return c >= 0x20 && c < 0x7F;
}

bool isAmong(char32_t c, std::string_view ascii)
{
    return c < 0x80 && ascii.find(static_cast<char>(c)) != std::string_view::npos;
}

bool isLetterOrDigit(char32_t c)
{
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// Letters and signs beyond ASCII that stand for themselves: no controls, separators of lines, invisible ones, or ones
/// that turn the direction of writing.
bool isSeen(char32_t c)
{
    struct Range {
        char32_t first, last;
    };
    constexpr std::array<Range, 18> kSeen{{{0xA1, 0xAC}, {0xAE, 0x34E}, {0x370, 0x5FF}, {0x620, 0x6DC}, {0x900, 0x115E},
        {0x1E00, 0x1FFF}, {0x2010, 0x2027}, {0x2030, 0x205E}, {0x2070, 0x2FFF}, {0x3001, 0x3163}, {0x3165, 0xD7FF},
        {0xF900, 0xFAFF}, {0xFE0F, 0xFE0F}, {0xFE30, 0xFE4F}, {0xFF01, 0xFF9F}, {kReplacement, kReplacement},
        {0x1F300, 0x1FAFF}, {0x20000, 0x2FFFD}}};
    return std::any_of(
        kSeen.begin(), kSeen.end(), [c](const Range& range) { return c >= range.first && c <= range.last; });
}

/// "\u00e9", and two of them beyond 16 bits: C#, JSON and JavaScript.
std::string inSixteenBits(char32_t c)
{
    if (c < 0x10000) {
        return "\\u" + digits(c, 16, 4);
    }
    const char32_t above = c - 0x10000;
    return "\\u" + digits(0xD800 + (above >> 10U), 16, 4) + "\\u" + digits(0xDC00 + (above & 0x3FFU), 16, 4);
}

std::string escapedForGodot(char32_t c)
{
    if (c == '"' || c == '\\') {
        return {'\\', static_cast<char>(c)};
    }
    return c < 0x80 ? "\\u" + digits(c, 16, 4) : utf8(isSeen(c) ? c : kReplacement);
}

std::string escapedForProtobuf(char32_t c)
{
    std::string out;
    for (const char byte : utf8(c)) {
        out += '\\' + digits(static_cast<unsigned char>(byte), 8, 3);
    }
    return out;
}

bool isNoCharacter(char32_t c)
{
    return (c & 0xFFFEU) == 0xFFFE || (c >= 0xFDD0 && c <= 0xFDEF);
}

/// A reference by number. HTML reads those of 0x80 to 0x9F as other characters, and XML has none of most controls.
std::string escapedForMarkup(char32_t c)
{
    const bool isControl = (c < 0x20 && c != '\t' && c != '\n') || (c >= 0x7F && c < 0xA0);
    return "&#x" + digits(isControl || isNoCharacter(c) ? kReplacement : c, 16, c < 0x10000 ? 4 : 6) + ";";
}

std::string escaped(Language language, char32_t c)
{
    switch (language) {
    case Language::CSharp:
    case Language::Json:
    case Language::JavaScript: return inSixteenBits(c);
    case Language::Python: return c < 0x10000 ? "\\u" + digits(c, 16, 4) : "\\U" + digits(c, 16, 8);
    case Language::Godot: return escapedForGodot(c);
    case Language::Protobuf: return escapedForProtobuf(c);
    case Language::Xml:
    case Language::Html: return escapedForMarkup(c);
    case Language::Shell:
    case Language::KeyValue: break;
    }
    return isSeen(c) ? utf8(c) : "_";
}

/// Signs of ASCII that mean something between quotes of one of the languages; the first two in all.
constexpr std::string_view kSpecial = "\"\\'&<>`$";

/// 'it'\''s', or $'\x01' where there is what cannot be seen.
std::string shellWord(std::string_view text)
{
    if (isOneLine(text)) { // it reads that between single quotes as it is, whatever it takes for letters
        std::string out = "'";
        for (const char c : text) {
            out += c == '\'' ? "'\\''" : std::string(1, c);
        }
        return out + "'";
    }
    std::string out = "$'";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        out += isPrintableAscii(byte) && !isAmong(byte, kSpecial) ? std::string(1, c) : "\\" + digits(byte, 8, 3);
    }
    return out + "'";
}

} // namespace

std::string written(Language language, std::string_view text)
{
    if (language == Language::Shell) {
        return shellWord(text);
    }
    std::string out;
    while (!text.empty()) {
        const char32_t c = takeCharacter(text);
        const std::string_view special = language == Language::Godot ? kSpecial.substr(0, 2) : kSpecial;
        const bool stays = isPrintableAscii(c) && (language == Language::KeyValue || !isAmong(c, special));
        out += stays ? std::string(1, static_cast<char>(c)) : escaped(language, c);
    }
    return out;
}

std::string labelOf(std::string_view name)
{
    std::string out;
    while (!name.empty()) {
        const char32_t c = takeCharacter(name);
        out += isLetterOrDigit(c) || isAmong(c, " -_.,()+@=") || isSeen(c) ? utf8(c) : "_";
    }
    return out;
}

bool isOneLine(std::string_view text)
{
    while (!text.empty()) {
        const char32_t c = takeCharacter(text);
        if (!isPrintableAscii(c) && (!isSeen(c) || c == kReplacement)) {
            return false;
        }
    }
    return true;
}

std::string identifierOf(std::string_view name)
{
    std::string out;
    std::uint32_t sum = 2166136261; // FNV-1a: "fire ball" and "fire_ball" are two
    bool isSame = true;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        sum = (sum ^ byte) * 16777619U;
        const bool stays = isLetterOrDigit(byte) || c == '_';
        isSame = isSame && stays;
        out += stays ? c : '_';
    }
    const bool hasLetterFirst =
        !out.empty() && isLetterOrDigit(static_cast<unsigned char>(out[0])) && (out[0] < '0' || out[0] > '9');
    return (hasLetterFirst ? "" : "sheet_") + out + (isSame && hasLetterFirst ? "" : "_" + digits(sum, 16, 8));
}

} // namespace fumage
