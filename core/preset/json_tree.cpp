#include "core/preset/json_tree.h"

#include "core/base/text.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include <nlohmann/json.hpp>

namespace fumage {

namespace {

constexpr std::size_t kDeepest = 32;

/// Feeds the parser and counts what it has read.
class CountingIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* at, std::size_t* count)
        : m_at(at)
        , m_count(count)
    {
    }
    reference operator*() const { return *m_at; }
    CountingIterator& operator++()
    {
        ++m_at;
        ++*m_count;
        return *this;
    }
    CountingIterator operator++(int)
    {
        CountingIterator before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const CountingIterator& a, const CountingIterator& b) { return a.m_at == b.m_at; }
    friend bool operator!=(const CountingIterator& a, const CountingIterator& b) { return !(a == b); }

private:
    const char* m_at;
    std::size_t* m_count;
};

/// Builds the tree from the parser's events; the open containers lie on a stack.
class TreeBuilder {
public:
    using number_integer_t = nlohmann::json::number_integer_t;
    using number_unsigned_t = nlohmann::json::number_unsigned_t;
    using number_float_t = nlohmann::json::number_float_t;
    using string_t = nlohmann::json::string_t;
    using binary_t = nlohmann::json::binary_t;

    TreeBuilder(std::string_view text, const std::size_t& consumed)
        : m_text(text)
        , m_consumed(consumed)
    {
    }

    bool null() { return add(literal(JsonNode::Type::Null, 4)); }
    bool boolean(bool value)
    {
        JsonNode node = literal(JsonNode::Type::Bool, value ? 4 : 5);
        node.flag = value;
        return add(std::move(node));
    }
    bool number_integer(number_integer_t value) { return number(static_cast<double>(value), true); }
    bool number_unsigned(number_unsigned_t value) { return number(static_cast<double>(value), true); }
    bool number_float(number_float_t value, const string_t& /*raw*/) { return number(value, false); }
    bool string(string_t& value)
    {
        JsonNode node = stringNode();
        node.string = std::move(value);
        return add(std::move(node));
    }
    bool binary(binary_t& /*value*/) { return false; }
    bool start_object(std::size_t /*elements*/) { return open(JsonNode::Type::Object); }
    bool start_array(std::size_t /*elements*/) { return open(JsonNode::Type::Array); }
    bool end_object() { return keysDiffer() && close(); }
    bool end_array() { return close(); }
    bool key(string_t& name)
    {
        m_open.back().key = std::move(name);
        m_open.back().keyPlaces.push_back(stringNode().begin);
        return true;
    }
    bool parse_error(std::size_t position, const std::string& /*token*/, const nlohmann::detail::exception& cause)
    {
        const std::string what = cause.what();
        const std::size_t at = position == 0 ? m_consumed : position - 1;
        constexpr int kNumberOverflow = 406;
        const std::size_t wordStart = m_text.substr(0, at).find_last_of(" \t\r\n,:[{") + 1;
        const std::string_view word = m_text.substr(wordStart);
        if (cause.id == kNumberOverflow || word.starts_with("NaN") || word.starts_with("Inf")
            || word.starts_with("-Inf")) {
            return fail(ErrorCode::NotFinite, makeMessage("the number is not finite"), wordStart,
                makeMessage("Use a plain number such as 1.5"));
        }
        if (what.find("UTF-8") != std::string::npos) {
            return fail(
                ErrorCode::NotUtf8, makeMessage("the text is not UTF-8"), at, makeMessage("Save the file as UTF-8"));
        }
        if (at >= m_text.size()) {
            return fail(ErrorCode::Syntax, makeMessage("the file ends in the middle"), m_text.size(),
                makeMessage("It may have been cut off; use a copy of it"));
        }
        return fail(ErrorCode::Syntax, makeMessage("this is not JSON: %1", reason(what)), at, {});
    }

    [[nodiscard]] JsonNode& root() { return m_root; }
    [[nodiscard]] const Error& error() const { return m_error; }

private:
    /// An array or object whose end has not been read.
    struct Container {
        JsonNode node;
        std::string key; ///< waits for its value
        std::vector<std::size_t> keyPlaces;
    };

    static std::string reason(const std::string& what)
    {
        const std::size_t dash = what.rfind(" - ");
        const std::string tail = dash == std::string::npos ? what : what.substr(dash + 3);
        return tail.substr(0, tail.find("; last read"));
    }

    bool fail(ErrorCode code, Message message, std::size_t offset, Message remedy)
    {
        m_error = {code, std::move(message), placeInText(m_text, offset), std::move(remedy)};
        return false;
    }

    [[nodiscard]] JsonNode literal(JsonNode::Type type, std::size_t length) const
    {
        JsonNode node;
        node.type = type;
        node.end = m_consumed;
        node.begin = m_consumed - length;
        return node;
    }

    /// The string whose closing quote was read last: its start is the nearest quote before it that is not escaped.
    [[nodiscard]] JsonNode stringNode() const
    {
        JsonNode node;
        node.type = JsonNode::Type::String;
        node.end = m_consumed;
        std::size_t at = m_consumed - 1;
        for (;;) {
            at = m_text.rfind('"', at - 1);
            std::size_t slashes = 0;
            while (slashes < at && m_text[at - 1 - slashes] == '\\') {
                ++slashes;
            }
            if (slashes % 2 == 0) {
                break;
            }
        }
        node.begin = at;
        return node;
    }

    bool number(double value, bool whole)
    {
        // A number ends at the first character that cannot be part of it, which has been read too, unless the text
        // ended.
        constexpr std::string_view kNumberCharacters = "0123456789+-.eE";
        JsonNode node;
        node.type = JsonNode::Type::Number;
        node.number = value;
        node.isWhole = whole;
        node.end = m_consumed;
        if (node.end > 0 && kNumberCharacters.find(m_text[node.end - 1]) == std::string_view::npos) {
            --node.end;
        }
        const std::size_t before = m_text.substr(0, node.end).find_last_not_of(kNumberCharacters);
        node.begin = before == std::string_view::npos ? 0 : before + 1;
        return add(std::move(node));
    }

    bool open(JsonNode::Type type)
    {
        if (m_open.size() == kDeepest) {
            return fail(ErrorCode::TooDeep, makeMessage("brackets are nested more than %1 deep", kDeepest),
                m_consumed - 1, makeMessage("This is not a preset"));
        }
        Container container;
        container.node.type = type;
        container.node.begin = m_consumed - 1;
        m_open.push_back(std::move(container));
        return true;
    }

    /// Sorts the keys once the object is complete: looking each one up as it comes would cost the square of their
    /// number.
    bool keysDiffer()
    {
        const std::vector<std::string>& keys = m_open.back().node.keys;
        std::vector<std::size_t> order(keys.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
        const auto twice = std::adjacent_find(
            order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] == keys[b]; });
        if (twice == order.end()) {
            return true;
        }
        const std::size_t second = *(twice + 1);
        return fail(ErrorCode::Syntax, makeMessage("the key %1 is there twice", inQuotes(keys[second])),
            m_open.back().keyPlaces[second], makeMessage("Remove one of them"));
    }

    bool close()
    {
        JsonNode node = std::move(m_open.back().node);
        node.end = m_consumed;
        m_open.pop_back();
        return add(std::move(node));
    }

    bool add(JsonNode node)
    {
        if (m_open.empty()) {
            m_root = std::move(node);
            return true;
        }
        Container& container = m_open.back();
        if (container.node.type == JsonNode::Type::Object) {
            container.node.keys.push_back(std::move(container.key));
        }
        container.node.items.push_back(std::move(node));
        return true;
    }

    std::string_view m_text;
    const std::size_t& m_consumed;
    std::vector<Container> m_open;
    JsonNode m_root;
    Error m_error;
};

/// JSON begins with an ASCII character, so that UTF-16 and UTF-32 have zero bytes there, unless they begin with a mark.
/// @return the encoding of a text that is not UTF-8; empty where it may be
std::string_view otherEncodingOf(std::string_view text)
{
    using namespace std::string_view_literals;
    const std::string_view begin = text.substr(0, 4);
    const auto areZeros = [&](std::size_t at, std::size_t count) {
        return begin.size() == 4 && begin.substr(at, count).find_first_not_of('\0') == std::string_view::npos;
    };
    const bool isMarked32 = begin == "\xFF\xFE\0\0"sv || begin == "\0\0\xFE\xFF"sv;
    if (isMarked32 || (areZeros(1, 3) && begin[0] != '\0') || (areZeros(0, 3) && begin[3] != '\0')) {
        return "UTF-32";
    }
    const bool isMarked16 = begin.starts_with("\xFF\xFE") || begin.starts_with("\xFE\xFF");
    return isMarked16 || (begin.size() >= 2 && (begin[0] == '\0') != (begin[1] == '\0')) ? "UTF-16" : "";
}

} // namespace

const JsonNode* JsonNode::find(std::string_view key) const
{
    const auto found = std::find(keys.begin(), keys.end(), key);
    return found == keys.end() ? nullptr : &items[static_cast<std::size_t>(found - keys.begin())];
}

Result<JsonNode> parseJson(std::string_view text)
{
    if (const std::string_view encoding = otherEncodingOf(text); !encoding.empty()) {
        return Error{ErrorCode::NotUtf8, makeMessage("the text is %1", encoding), placeInText(text, 0),
            makeMessage("Save the file as UTF-8")};
    }
    // The parser would take a zero byte for the end of the text.
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
        return Error{ErrorCode::Syntax, makeMessage("this is not JSON: there is a zero byte"), placeInText(text, zero),
            makeMessage("It may be a binary file or a damaged one")};
    }
    std::size_t consumed = 0;
    TreeBuilder builder(text, consumed);
    const CountingIterator begin(text.data(), &consumed);
    const CountingIterator end(text.data() + text.size(), &consumed);
    if (!nlohmann::json::sax_parse(begin, end, &builder)) {
        return builder.error();
    }
    return std::move(builder.root());
}

std::size_t bytesWithoutLongTexts(std::string_view json)
{
    constexpr std::size_t kLong = 4096;
    std::size_t bytes = json.size();
    std::size_t at = json.find('"');
    while (at != std::string_view::npos) {
        std::size_t end = json.find_first_of("\"\\", at + 1);
        while (end != std::string_view::npos && json[end] == '\\') {
            end = json.find_first_of("\"\\", std::min(end + 2, json.size()));
        }
        if (end == std::string_view::npos) {
            break;
        }
        const std::size_t length = end - at - 1;
        bytes -= length > kLong ? length : 0;
        at = json.find('"', end + 1);
    }
    return bytes;
}

Message placeInText(std::string_view text, std::size_t offset)
{
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t start = before.rfind('\n') + 1; // npos + 1 is 0
    constexpr unsigned char kContinuationMask = 0xC0;
    constexpr unsigned char kContinuation = 0x80;
    const auto column = std::count_if(before.begin() + static_cast<std::ptrdiff_t>(start), before.end(), [](char c) {
        return (static_cast<unsigned char>(c) & kContinuationMask) != kContinuation;
    }) + 1;
    return makeMessage("line %1, column %2", line, column);
}

Message placeInFile(const std::string& file, const Message& inText)
{
    return file.empty() ? inText : makeMessage("%1, %2", file, inText);
}

Result<JsonNode> parseJsonOf(const std::string& file, std::string_view text)
{
    Result<JsonNode> root = parseJson(text);
    if (root) {
        return root;
    }
    Error error = root.error();
    error.place = placeInFile(file, error.place);
    return error;
}

std::string quoteJson(std::string_view text)
{
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace fumage
