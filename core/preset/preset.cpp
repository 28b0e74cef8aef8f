#include "core/preset/preset.h"

#include "core/base/file.h"
#include "core/base/open_file.h"
#include "core/base/text.h"
#include "core/effect/parameter_table.h"
#include "core/effect/value.h"
#include "core/picture_files/picture_notes.h"
#include "core/preset/preset_node.h"

#include <algorithm>
#include <array>

namespace fumage {

namespace {

constexpr std::array<std::string_view, 4> kHeaderKeys{"format", "version", "name", "description"};
/// Where editors of text look for the schema; kept, and nothing to warn of.
constexpr std::string_view kSchemaKey = "$schema";
class Reader {
public:
    Reader(std::string_view text, const std::string& place, std::size_t mostWarnings)
        : m_text(text)
        , m_place(place)
        , m_mostWarnings(mostWarnings)
    {
    }

    Result<PresetReading> read()
    {
        if (m_text.size() > kMaxPresetBytes) {
            return tooLarge(m_text.size(), m_place);
        }
        const Result<JsonNode> root = parseJsonOf(m_place, m_text);
        if (!root) {
            return root.error();
        }
        return read(root.value());
    }

    Result<PresetReading> read(const JsonNode& root)
    {
        if (root.end - root.begin > kMaxPresetBytes) {
            return tooLarge(root.end - root.begin, placeInFile(m_place, placeInText(m_text, root.begin)));
        }
        if (Status status = readRoot(root); !status) {
            return status.error();
        }
        reportHidden();
        reportMissing();
        return std::move(m_reading);
    }

private:
    static Error tooLarge(std::size_t bytes, const Message& place)
    {
        return {ErrorCode::TooLarge, said("a preset of %1 bytes", bytes), place, said("Presets have at most %1", kMaxPresetBytes)};
    }

    [[nodiscard]] Error errorAt(const JsonNode& node, ErrorCode code, Message message, Message remedy) const
    {
        return {code, std::move(message), placeInFile(m_place, placeInText(m_text, node.begin)), std::move(remedy)};
    }

    /// @param message called only where there is room for it: a place and a suggestion cost far more than reading what they are about
    template <class Say>
    void warn(const JsonNode& node, const Say& message)
    {
        ++m_warnings;
        if (m_warnings <= m_mostWarnings) {
            m_reading.warnings.push_back(said("%1: %2", placeInFile(m_place, placeInText(m_text, node.begin)), message()));
        }
    }

    void warnOfFile(const Message& message) { m_reading.warnings.push_back(m_place.empty() ? message : said("%1: %2", m_place, message)); }

    Status readRoot(const JsonNode& root)
    {
        if (root.type != JsonNode::Type::Object) {
            return errorAt(root, ErrorCode::WrongType, said("a preset is an object in braces { }"), {});
        }
        if (Status status = readHeader(root); !status) {
            return status;
        }
        for (std::size_t i = 0; i < root.items.size(); ++i) {
            const std::string& key = root.keys[i];
            const JsonNode& node = root.items[i];
            if (std::find(kHeaderKeys.begin(), kHeaderKeys.end(), key) != kHeaderKeys.end()) {
                continue;
            }
            if (Status status = groupLabel(key).empty() ? keepUnknown("", key, node) : readGroup(key, node); !status) {
                return status;
            }
        }
        return Done{};
    }

    Status readHeader(const JsonNode& root)
    {
        const JsonNode* format = root.find("format");
        if (format == nullptr || format->string != kPresetFormat) {
            return errorAt(format == nullptr ? root : *format, ErrorCode::WrongType, said("this JSON is not a Fumage preset"), said("A preset begins with \"format\": \"fumage-preset\""));
        }
        const JsonNode* version = root.find("version");
        if (version == nullptr || version->type != JsonNode::Type::Number || !version->isWhole || version->number < 1.0) {
            return errorAt(version == nullptr ? root : *version, ErrorCode::WrongVersion, said("the version of the preset is missing or not a whole number from 1"), {});
        }
        if (version->number > kPresetVersion) {
            return errorAt(*version, ErrorCode::WrongVersion,
                said("the preset has version %1, this program reads up to %2", m_text.substr(version->begin, version->end - version->begin), kPresetVersion), said("Open it with a newer Fumage"));
        }
        for (const auto& [key, to] : {std::pair{"name", &m_reading.preset.name}, std::pair{"description", &m_reading.preset.description}}) {
            const JsonNode* node = root.find(key);
            if (node != nullptr && node->type != JsonNode::Type::String) {
                return errorAt(*node, ErrorCode::WrongType, said("%1: expected a text in quotes", key), {});
            }
            *to = node == nullptr ? "" : node->string;
        }
        return Done{};
    }

    Status readGroup(const std::string& group, const JsonNode& node)
    {
        if (node.type != JsonNode::Type::Object) {
            return errorAt(node, ErrorCode::WrongType, said("%1: expected an object in braces { }", group), {});
        }
        for (std::size_t i = 0; i < node.items.size(); ++i) {
            const std::string& name = node.keys[i];
            const JsonNode& value = node.items[i];
            const Parameter* parameter = findParameter(group + "." + name);
            if (Status status = parameter == nullptr ? keepUnknown(group, name, value) : readParameter(*parameter, value); !status) {
                return status;
            }
        }
        return Done{};
    }

    Status keepUnknown(const std::string& group, const std::string& key, const JsonNode& node)
    {
        const std::string path = group.empty() ? key : group + "." + key;
        if (path != kSchemaKey) {
            warn(node, [&] {
                const std::string_view near = nearestParameterKey(path);
                return near.empty() ? said("unknown key %1 is kept but has no effect", inQuotes(path)) : said("unknown key %1 is kept but has no effect; did you mean %2?", inQuotes(path), inQuotes(near));
            });
        }
        m_reading.preset.unknown.push_back({group, key, std::string(m_text.substr(node.begin, node.end - node.begin))});
        return Done{};
    }

    Status readParameter(const Parameter& parameter, const JsonNode& node)
    {
        const Result<Clamped> value = valueOf(parameter, node);
        if (!value) {
            return errorAt(node, value.error().code, said("%1: %2", value.error().place, value.error().message), value.error().remedy);
        }
        if (setClamped(m_reading.preset.effect, parameter, value.value())) {
            warn(node, [&] { return said("%1 was out of range and is now %2", parameter.key, formatText(parameter, parameter.get(m_reading.preset.effect), true)); });
        }
        m_seen.push_back(parameter.key);
        return Done{};
    }

    [[nodiscard]] Result<Clamped> valueOf(const Parameter& parameter, const JsonNode& node) const
    {
        const bool isChoice = isText(node) && parameter.kind == Kind::Choice;
        const bool isFlag = node.type == JsonNode::Type::Bool && parameter.kind == Kind::Bool;
        if (isChoice) {
            return parseValue(parameter, node.string);
        }
        if (isFlag) {
            return Clamped{node.flag};
        }
        std::vector<double> numbers;
        if (!collectNumbers(parameter, node, numbers)) {
            return Error{ErrorCode::WrongType,
                said("expected %1, found %2", kindName(parameter.kind),
                    inQuotes(isText(node) ? node.string : m_text.substr(node.begin, node.end - node.begin))),
                std::string(parameter.key), {}};
        }
        return valueFromNumbers(parameter, numbers);
    }

    static bool isText(const JsonNode& node) { return node.type == JsonNode::Type::String; }

    /// A number, a list of three, or a list of lists, just as the kind asks.
    static bool collectNumbers(const Parameter& parameter, const JsonNode& node, std::vector<double>& numbers)
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
                && std::all_of(
                    node.items.begin(), node.items.end(), [&](const JsonNode& item) { return flat(item, 2); });
        case Kind::Gradient:
            return node.type == JsonNode::Type::Array
                && std::all_of(
                    node.items.begin(), node.items.end(), [&](const JsonNode& item) { return flat(item, 4); });
        case Kind::Bool:
        case Kind::Choice: return false;
        }
        return false;
    }

    void reportHidden()
    {
        if (m_warnings > m_mostWarnings) {
            warnOfFile(said("and %1 more warnings", m_warnings - m_mostWarnings));
        }
    }

    void reportMissing()
    {
        std::size_t missing = 0;
        std::string first;
        for (const Parameter& parameter : parameterTable()) {
            if (std::find(m_seen.begin(), m_seen.end(), parameter.key) == m_seen.end()) {
                first = missing == 0 ? std::string(parameter.key) : first;
                ++missing;
            }
        }
        if (missing > 0) {
            warnOfFile(said("%1 parameters are not in the preset and keep their defaults, the first is %2", missing, first));
        }
    }

    std::string_view m_text;
    const std::string& m_place;
    std::size_t m_mostWarnings;
    PresetReading m_reading;
    std::size_t m_warnings = 0; ///< all of them, shown or not
    std::vector<std::string_view> m_seen;
};

void writeUnknown(const Preset& preset, std::string_view group, std::string_view indent, std::string& out)
{
    for (const UnknownMember& member : preset.unknown) {
        if (member.group == group) {
            out += ",\n" + std::string(indent) + quoteJson(member.key) + ": " + member.json;
        }
    }
}

/// The preset that a picture carries.
Result<PresetReading> readPicture(const std::filesystem::path& path)
{
    const Result<OpenFile> file = OpenFile::open(path);
    if (!file) {
        return file.error();
    }
    const Result<PictureNotes> notes =
        readPictureNotes([&](std::uint64_t at, std::size_t size) { return file.value().readAt(at, size); });
    if (!notes) {
        Error error = notes.error();
        error.place = path.string();
        return error;
    }
    if (notes.value().preset.empty()) {
        return Error{ErrorCode::WrongType, said("this picture carries no preset"), path.string(), said("Choose a PNG or EXR that Fumage has written, or the preset's own file")};
    }
    Result<PresetReading> reading = parsePreset(notes.value().preset, path.string());
    if (!reading) {
        Error error = reading.error();
        error.message = said("the preset that this picture carries cannot be read: %1", error.message);
        return error;
    }
    reading.value().frame = std::max(0, notes.value().frame);
    reading.value().sheet = notes.value().sheet;
    return reading;
}

} // namespace

Result<PresetReading> parsePreset(std::string_view json, const std::string& place)
{
    return Reader(json, place, kMostWarnings).read();
}

Result<PresetReading> readPreset(std::string_view text, const JsonNode& root, const std::string& place, std::size_t mostWarnings)
{
    return Reader(text, place, mostWarnings).read(root);
}

std::string formatPreset(const Preset& preset)
{
    std::string out = "{\n  \"format\": " + quoteJson(kPresetFormat) + ",\n  \"version\": " + std::to_string(kPresetVersion) + ",\n  \"name\": " + quoteJson(preset.name)
        + ",\n  \"description\": " + quoteJson(preset.description);
    std::string_view group;
    for (const Parameter& parameter : parameterTable()) {
        if (parameter.group() != group) {
            if (!group.empty()) {
                writeUnknown(preset, group, "    ", out);
                out += "\n  }";
            }
            group = parameter.group();
            out += ",\n  " + quoteJson(group) + ": {\n    ";
        } else {
            out += ",\n    ";
        }
        out += quoteJson(parameter.name()) + ": " + formatJson(parameter, parameter.get(preset.effect));
    }
    writeUnknown(preset, group, "    ", out);
    out += "\n  }";
    writeUnknown(preset, "", "  ", out);
    return out + "\n}\n";
}

Result<PresetReading> readPresetFile(const std::filesystem::path& path)
{
    constexpr std::size_t kSignature = 8;
    if (const Result<std::string> begin = readFileHead(path, kSignature); begin && isPicture(begin.value())) {
        return readPicture(path);
    }
    const Result<std::string> text = readFile(path, kMaxPresetBytes);
    return text ? parsePreset(text.value(), path.string()) : Result<PresetReading>(text.error());
}

Status writePresetFile(const std::filesystem::path& path, const Preset& preset)
{
    return writeFileAtomically(path, formatPreset(preset));
}

} // namespace fumage
