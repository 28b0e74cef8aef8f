#include "core/preset/preset_node.h"

#include "core/base/text.h"
#include "core/effect/parameter_table.h"
#include "core/effect/value.h"
#include "core/preset/layer_node.h"
#include "core/preset/marker_node.h"
#include "core/preset/migration.h"
#include "core/preset/parameter_node.h"
#include "core/preset/preset_keys.h"
#include "core/preset/track_node.h"

#include <algorithm>
#include <array>
#include <functional>

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

    Result<PresetReading> read(const JsonNode& root)
    {
        if (const std::optional<Error> error = presetTooLarge(m_text.substr(root.begin, root.end - root.begin),
                placeInFile(m_place, placeInText(m_text, root.begin)))) {
            return *error;
        }
        if (Status status = readRoot(root); !status) {
            return status.error();
        }
        putTogether();
        reportHidden();
        reportMissing();
        return std::move(m_reading);
    }

private:
    /// Parameters of the scene, or of one of its layers, as far as they have been read.
    struct Part {
        Effect effect;
        std::vector<std::string_view> seen;
        const JsonNode* from = nullptr; ///< what names the layer's parent
    };

    [[nodiscard]] Error errorAt(const JsonNode& node, ErrorCode code, Message message, Message remedy) const
    {
        return {code, std::move(message), placeInFile(m_place, placeInText(m_text, node.begin)), std::move(remedy)};
    }

    /// @param message called only where there is room for it: a place and a suggestion cost far more than reading what
    /// they are about
    template <class Say>
    void warn(const JsonNode& node, const Say& message)
    {
        ++m_warnings;
        if (m_warnings <= m_mostWarnings) {
            m_reading.warnings.push_back(
                makeMessage("%1: %2", placeInFile(m_place, placeInText(m_text, node.begin)), message()));
        }
    }

    void warnOfFile(const Message& message)
    {
        m_reading.warnings.push_back(m_place.empty() ? message : makeMessage("%1: %2", m_place, message));
    }

    Status readRoot(const JsonNode& root)
    {
        if (root.type != JsonNode::Type::Object) {
            return errorAt(root, ErrorCode::WrongType, makeMessage("a preset is an object in braces { }"), {});
        }
        const Result<int> version = readHeader(root);
        if (!version) {
            return version.error();
        }
        m_version = version.value();
        if (m_version == kPresetVersion) {
            return readMembers(root);
        }
        JsonNode migrated = root;
        migratePreset(migrated, m_version);
        return readMembers(migrated);
    }

    Status readMembers(const JsonNode& root)
    {
        for (std::size_t i = 0; i < root.items.size(); ++i) {
            const std::string& key = root.keys[i];
            const JsonNode& node = root.items[i];
            if (std::find(kHeaderKeys.begin(), kHeaderKeys.end(), key) != kHeaderKeys.end()) {
                continue;
            }
            const auto read = [&] {
                return key == kScene ? readGroups(kScene, Scope::Scene, node)
                    : key == kLayers ? readLayers(node)
                                     : keepUnknown("", key, node);
            };
            if (Status status = read(); !status) {
                return status;
            }
        }
        return Done{};
    }

    Status readLayers(const JsonNode& node)
    {
        if (node.type != JsonNode::Type::Array) {
            return errorAt(node, ErrorCode::WrongType, makeMessage("%1: expected a list in brackets [ ]", kLayers), {});
        }
        if (node.items.empty() || node.items.size() > kMaxLayers) {
            return errorAt(node, ErrorCode::OutOfRange,
                makeMessage("the preset has %1 layers, from 1 to %2 are possible", node.items.size(), kMaxLayers), {});
        }
        m_reading.preset.scene.layers.resize(node.items.size());
        m_layers.assign(node.items.size(), {});
        for (m_layer = 0; m_layer < node.items.size(); ++m_layer) {
            m_part = &m_layers[m_layer];
            if (Status status = readGroups(kLayer, Scope::Layer, node.items[m_layer]); !status) {
                return status;
            }
        }
        m_part = &m_surroundings;
        m_layer = 0;
        return checkParents();
    }

    [[nodiscard]] Status checkParents() const
    {
        for (std::size_t layer = 0; layer < m_layers.size(); ++layer) {
            if (const Status status = checkParent(m_reading.preset.scene, layer); !status) {
                return errorAt(
                    *m_layers[layer].from, status.error().code, status.error().message, status.error().remedy);
            }
        }
        return Done{};
    }

    /// @param owner what the groups belong to
    Status readGroups(std::string_view owner, Scope scope, const JsonNode& node)
    {
        if (node.type != JsonNode::Type::Object) {
            return errorAt(node, ErrorCode::WrongType, makeMessage("%1: expected an object in braces { }", owner), {});
        }
        for (std::size_t i = 0; i < node.items.size(); ++i) {
            const std::string& key = node.keys[i];
            const JsonNode& group = node.items[i];
            const Result<bool> isRead = readMember(scope, key, group);
            if (!isRead) {
                return isRead.error();
            }
            if (isRead.value()) {
                continue;
            }
            const auto read = [&] {
                return key == kAnimation       ? readAnimation(scope, group)
                    : groupScope(key) == scope ? readGroup(key, group)
                                               : keepUnknown(std::string(owner), key, group);
            };
            if (Status status = read(); !status) {
                return status;
            }
        }
        return Done{};
    }

    /// How others say what is wrong here.
    NodeTalk talk()
    {
        return {std::bind_front(&Reader::errorAt, this),
            [this](const JsonNode& at, const Message& message) { warn(at, [&] { return message; }); }};
    }

    /// Whether a member of the scene or of a layer is one that stands beside the groups, and was read.
    Result<bool> readMember(Scope scope, const std::string& key, const JsonNode& node)
    {
        if (scope == Scope::Layer) {
            m_part->from = key == kLayerFrom ? &node : m_part->from;
            return readLayerMember(key, node, talk(), m_reading.preset.scene.layers[m_layer]);
        }
        if (key != kMarkers) {
            return false;
        }
        Result<MarkersReading> reading = readMarkers(node, m_text, talk());
        if (!reading) {
            return reading.error();
        }
        m_reading.preset.scene.markers = std::move(reading.value().markers);
        for (const std::string& json : reading.value().unknown) {
            m_reading.preset.unknown.push_back({std::string(kMarkers), {}, json, 0, true});
        }
        return true;
    }

    /// @param scope whose parameters the tracks are of
    Status readAnimation(Scope scope, const JsonNode& node)
    {
        const Result<TracksReading> reading = readTracks(node, scope, m_text, talk());
        if (!reading) {
            return reading.error();
        }
        Scene& scene = m_reading.preset.scene;
        (scope == Scope::Scene ? scene.tracks : scene.layers[m_layer].tracks) = reading.value().tracks;
        for (const std::string& json : reading.value().unknown) {
            m_reading.preset.unknown.push_back({std::string(kAnimation), {}, json, m_layer, scope == Scope::Scene});
        }
        return Done{};
    }

    /// @return the version of the preset, at most kPresetVersion
    Result<int> readHeader(const JsonNode& root)
    {
        const JsonNode* format = root.find("format");
        if (format == nullptr || format->string != kPresetFormat) {
            return errorAt(format == nullptr ? root : *format, ErrorCode::WrongType,
                makeMessage("this JSON is not a Fumage preset"),
                makeMessage("A preset begins with \"format\": \"fumage-preset\""));
        }
        const JsonNode* version = root.find("version");
        if (version == nullptr || version->type != JsonNode::Type::Number || !version->isWhole
            || version->number < 1.0) {
            return errorAt(version == nullptr ? root : *version, ErrorCode::WrongVersion,
                makeMessage("the version of the preset is missing or not a whole number from 1"), {});
        }
        if (version->number > kPresetVersion) {
            return errorAt(*version, ErrorCode::WrongVersion,
                makeMessage("the preset has version %1, this program reads up to %2",
                    m_text.substr(version->begin, version->end - version->begin), kPresetVersion),
                makeMessage("Open it with a newer Fumage"));
        }
        for (const auto& [key, to] :
            {std::pair{"name", &m_reading.preset.name}, std::pair{"description", &m_reading.preset.description}}) {
            const JsonNode* node = root.find(key);
            if (node != nullptr && node->type != JsonNode::Type::String) {
                return errorAt(*node, ErrorCode::WrongType, makeMessage("%1: expected a text in quotes", key), {});
            }
            *to = node == nullptr ? "" : node->string;
        }
        return static_cast<int>(version->number);
    }

    Status readGroup(const std::string& group, const JsonNode& node)
    {
        if (node.type != JsonNode::Type::Object) {
            return errorAt(node, ErrorCode::WrongType, makeMessage("%1: expected an object in braces { }", group), {});
        }
        for (std::size_t i = 0; i < node.items.size(); ++i) {
            const std::string& name = node.keys[i];
            const JsonNode& value = node.items[i];
            const Parameter* parameter = findParameter(group + "." + name);
            if (Status status =
                    parameter == nullptr ? keepUnknown(group, name, value) : readParameter(*parameter, value);
                !status) {
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
                return near.empty() ? makeMessage("unknown key %1 is kept but has no effect", inQuotes(path))
                                    : makeMessage("unknown key %1 is kept but has no effect; did you mean %2?",
                                        inQuotes(path), inQuotes(near));
            });
        }
        m_reading.preset.unknown.push_back(
            {group, key, std::string(m_text.substr(node.begin, node.end - node.begin)), m_layer});
        return Done{};
    }

    Status readParameter(const Parameter& parameter, const JsonNode& node)
    {
        const Result<Clamped> value = valueOf(parameter, node, m_text);
        if (!value) {
            const Error& error = value.error();
            const Message what = makeMessage("%1: %2", error.place, error.message);
            if (parameter.kind == Kind::Picture) {
                return errorAt(node, error.code, ofLayer(what), error.remedy.empty() ? pictureRemedy() : error.remedy);
            }
            return errorAt(node, error.code, what, error.remedy);
        }
        if (setClamped(m_part->effect, parameter, value.value())) {
            warn(node, [&] {
                return makeMessage("%1 was out of range and is now %2", parameter.key,
                    formatText(parameter, parameter.get(m_part->effect), true));
            });
        }
        m_part->seen.push_back(parameter.key);
        return Done{};
    }

    /// Says whose something is: lines of a text with pictures are too long to be looked for.
    [[nodiscard]] Message ofLayer(const Message& what) const
    {
        const std::string& name = m_reading.preset.scene.layers[m_layer].name;
        return makeMessage("layer %1: %2", name.empty() ? std::to_string(m_layer + 1) : inQuotes(name), what);
    }

    void reportHidden()
    {
        if (m_warnings > m_mostWarnings) {
            warnOfFile(makeMessage("and %1 more warnings", m_warnings - m_mostWarnings));
        }
    }

    void putTogether()
    {
        Scene& scene = m_reading.preset.scene;
        for (std::size_t layer = 0; layer < scene.layers.size(); ++layer) {
            scene.assign(layer, m_layers[layer].effect);
        }
        scene.setSurroundings(m_surroundings.effect);
    }

    void reportMissing()
    {
        std::size_t missing = 0;
        std::string first;
        const auto look = [&](const Part& part, Scope scope) {
            for (const Parameter& parameter : parameterTable()) {
                const bool isSeen = std::find(part.seen.begin(), part.seen.end(), parameter.key) != part.seen.end();
                if (parameter.scope == scope && !isSeen && parameter.since <= m_version) {
                    first = missing == 0 ? std::string(parameter.key) : first;
                    ++missing;
                }
            }
        };
        for (const Part& layer : m_layers) {
            look(layer, Scope::Layer);
        }
        look(m_surroundings, Scope::Scene);
        if (missing > 0) {
            warnOfFile(makeMessage(
                "%1 parameters are not in the preset and keep their defaults, the first is %2", missing, first));
        }
    }

    std::string_view m_text;
    const std::string& m_place;
    std::size_t m_mostWarnings;
    int m_version = kPresetVersion; ///< that the preset was written in
    PresetReading m_reading;
    std::size_t m_warnings = 0; ///< all of them, shown or not
    Part m_surroundings;
    std::vector<Part> m_layers{Part()};
    Part* m_part = &m_surroundings; ///< that is being read
    std::size_t m_layer = 0; ///< number of it among the layers
};

} // namespace

std::optional<Error> presetTooLarge(std::string_view json, const Message& place)
{
    const std::size_t bytes = json.size() <= kMaxPresetBytes ? json.size() : bytesWithoutLongTexts(json);
    if (bytes <= kMaxPresetBytes && json.size() <= kMaxPresetFileBytes) {
        return std::nullopt;
    }
    const bool isOfPictures = bytes <= kMaxPresetBytes;
    return Error{ErrorCode::TooLarge, makeMessage("a preset of %1 bytes", isOfPictures ? json.size() : bytes), place,
        makeMessage("Presets have at most %1", isOfPictures ? kMaxPresetFileBytes : kMaxPresetBytes)};
}

Result<PresetReading> readPreset(
    std::string_view text, const JsonNode& root, const std::string& place, std::size_t mostWarnings)
{
    return Reader(text, place, mostWarnings).read(root);
}

} // namespace fumage
