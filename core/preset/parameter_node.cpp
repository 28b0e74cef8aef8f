#include "core/preset/parameter_node.h"

#include "core/base/text.h"

#include <algorithm>

namespace fumage {

namespace {

/// A number, a list of three, or a list of lists, just as the kind asks.
bool collectNumbers(const Parameter& parameter, const JsonNode& node, std::vector<double>& numbers)
{
    const auto flat = [&](const JsonNode& list, std::size_t count) {
        for (const JsonNode& item : list.items) {
            if (item.type != JsonNode::Type::Number) {
                return false;
            }
            numbers.push_back(item.number);
        }
        return list.type == JsonNode::Type::Array && list.items.size() == count;
    };
    switch (parameter.kind) {
    case Kind::Int:
    case Kind::Seed:
    case Kind::Float: numbers.push_back(node.number); return node.type == JsonNode::Type::Number;
    case Kind::Direction:
    case Kind::Vector:
    case Kind::Colour: return flat(node, 3);
    case Kind::Curve:
        return node.type == JsonNode::Type::Array
            && std::all_of(node.items.begin(), node.items.end(), [&](const JsonNode& item) { return flat(item, 2); });
    case Kind::Gradient:
        return node.type == JsonNode::Type::Array
            && std::all_of(node.items.begin(), node.items.end(), [&](const JsonNode& item) { return flat(item, 4); });
    case Kind::Bool:
    case Kind::Choice:
    case Kind::Picture: return false;
    }
    return false;
}

} // namespace

Result<Clamped> valueOf(const Parameter& parameter, const JsonNode& node, std::string_view text)
{
    const bool isText = node.type == JsonNode::Type::String;
    const bool isWord = isText && (parameter.kind == Kind::Choice || parameter.kind == Kind::Picture);
    const bool isFlag = node.type == JsonNode::Type::Bool && parameter.kind == Kind::Bool;
    if (isWord) {
        return parseValue(parameter, node.string);
    }
    if (isFlag) {
        return Clamped{node.flag};
    }
    std::vector<double> numbers;
    if (!collectNumbers(parameter, node, numbers)) {
        return Error{ErrorCode::WrongType,
            makeMessage("expected %1, found %2", kindName(parameter.kind),
                inQuotes(isText ? node.string : text.substr(node.begin, node.end - node.begin))),
            std::string(parameter.key), {}};
    }
    return valueFromNumbers(parameter, numbers);
}

} // namespace fumage
