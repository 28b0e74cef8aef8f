#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// A JSON value that knows where it stands in its text, so that errors can say so.
struct JsonNode {
    enum class Type {
        Null,
        Bool,
        Number,
        String,
        Array,
        Object
    };

    Type type = Type::Null;
    std::size_t begin = 0; ///< bytes [begin, end) of the text
    std::size_t end = 0;
    bool flag = false;
    double number = 0.0; ///< finite
    bool isWhole = false; ///< written without fraction or exponent
    std::string string;
    std::vector<JsonNode> items; ///< of an array, or the values of an object, in the order of the file
    std::vector<std::string> keys; ///< of an object: keys[i] belongs to items[i]; they differ

    /// @return the member of an object with this key; null where there is none
    [[nodiscard]] const JsonNode* find(std::string_view key) const;
};

/// Parses JSON (RFC 8259).
/// @error Syntax, NotUtf8, NotFinite, TooDeep; the place is "line L, column C"
/// O(n log n) in the text, memory linear; nothing recurses while it parses.
[[nodiscard]] Result<JsonNode> parseJson(std::string_view text);

/// @return how many bytes a text has without what stands in quotes and is longer than 4 KiB, as pictures are: what a
/// tree of it costs beside them. O(n)
[[nodiscard]] std::size_t bytesWithoutLongTexts(std::string_view json);

/// @return "line L, column C" of a byte, both from 1; columns count characters, not bytes. O(offset)
[[nodiscard]] Message placeInText(std::string_view text, std::size_t offset);

/// A place in a text with the name of its file before it, where there is one: "smoke.json, line 3, column 5".
[[nodiscard]] Message placeInFile(const std::string& file, const Message& inText);
/// parseJson() of a file: errors name it.
[[nodiscard]] Result<JsonNode> parseJsonOf(const std::string& file, std::string_view text);

/// @return the text as a JSON string with its quotes
[[nodiscard]] std::string quoteJson(std::string_view text);

} // namespace fumage
