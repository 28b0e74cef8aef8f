#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace fumage::tests {

/// What names of files hold to break a language that they are written into: hundreds of them, without '/' and NUL,
/// which no name has.
inline std::vector<std::string> hostileNames()
{
    std::vector<std::string> pieces{"\"", "'", "\\", "\\\"", "\"\"\"", "'''", "`", "${x}", "$(touch x)", "`touch x`",
        "!x", "%s", "%d", "{0}", "{x}", "{{columns}}", "{{{columns}}}", "{{#loop}}", "{{=<% %>=}}", "<%", "<&>", "-->",
        "]]>", "&lt;", "&#x22;", "&quot;", "<script>", "<QUOTE>", "<STARTFRAME>", ";", "#", "\n#if X\n", "\\u0022",
        "\\x22", "\\N{QUOTATION MARK}", "\\", "%22", "@", "--x", "-x", " ", "  ", "~", "*", "?", "|", "=", ":", ",",
        "()", "[]", "\r\n", "\nEOF\n", "\u00e9", "e\u0301", "\u70df", "\u0440", "\U0001F525", "\U0010FFFF", "\u00a0",
        "\u00ad", "\u200b", "\u200d", "\u2028", "\u2029", "\u202e", "\u2066", "\u2060", "\ufeff", "\ufffd", "\ufffe",
        "\uffff", "\ufdd0", "\xff", "\xc3", "\xed\xa0\x80", "\xf5", "\x80",
        "\u2028#if !Q\u2028#define Q\u2028#undef UNITY_EDITOR\u2028class E{static void "
        "Main(){}}\u2028#endif\u2028#pragma x "};
    for (char c = 1; c < 0x20; ++c) {
        pieces.emplace_back(1, c);
    }
    pieces.emplace_back("\x7f");
    for (int c = 0x80; c < 0xA0; ++c) {
        pieces.push_back({'\xC2', static_cast<char>(c)});
    }
    std::vector<std::string> names;
    for (const std::string& piece : pieces) {
        names.push_back(piece + "a");
        names.push_back("a" + piece);
        names.push_back("a" + piece + "b" + piece);
    }
    std::mt19937 random(20);
    for (int i = 0; i < 200; ++i) {
        std::string name = "n";
        for (int j = 0; j < 4; ++j) {
            name += pieces[random() % pieces.size()];
        }
        names.push_back(name + "n");
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

} // namespace fumage::tests
