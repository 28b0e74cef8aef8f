#pragma once

#include <string>
#include <string_view>

namespace fumage {

/// What a text from outside (the name of a file, a folder or a preset) is written into.
enum class Language {
    CSharp, ///< between double quotes
    Python, ///< between double quotes
    Json, ///< between double quotes
    JavaScript, ///< between double quotes; engines of ECMAScript 5 as well
    Godot, ///< between double quotes, in scenes, import settings and shaders; bytes of UTF-8, for which Godot 3 has no
           ///< escape
    Protobuf, ///< between double quotes, in Protocol Buffers' text format
    Xml, ///< of an element or between quotes
    Html, ///< the same
    Shell, ///< a word of bash, with its quotes
    KeyValue, ///< a line "key=value", which has no escapes: what it cannot hold becomes '_'
};

/// A text as it is written in a language, so that the language's reader finds that very text, and nothing else.
/// Only characters of a short list stand as they are; all others are escaped as the language has it. What it cannot
/// hold at all (control characters in XML, bytes that are not UTF-8) becomes U+FFFD. Source: ECMA-334 6.4.5.6; Python's
/// reference 2.4.1; RFC 8259; ECMA-262 5.1, 7.8.4; Godot's VariantParser (documented by what it saves); Protocol
/// Buffers' text format specification; XML 1.0, 2.2 and 4.1; HTML 13.2.5.80; bash's manual 3.1.2.
[[nodiscard]] std::string written(Language language, std::string_view text);

/// A name that is only shown: letters, digits, spaces and a few signs, all others as '_'. It may stand in any of the
/// languages, in comments, too.
[[nodiscard]] std::string labelOf(std::string_view name);

/// Whether a text is one that a line "key=value" holds as it is.
[[nodiscard]] bool isOneLine(std::string_view text);

/// A name that programs take for one: letters, digits and underscores of ASCII, with a letter first. Those of different
/// names differ.
[[nodiscard]] std::string identifierOf(std::string_view name);

} // namespace fumage
