#include "core/preset/preset_file.h"

#include "core/base/base64.h"
#include "core/system/file.h"
#include "core/system/open_file.h"
#include "core/effect/parameter_table.h"
#include "core/effect/value.h"
#include "core/image_io/metadata_reader.h"
#include "core/preset/marker_node.h"
#include "core/preset/preset_keys.h"
#include "core/preset/preset_node.h"
#include "core/preset/track_node.h"

#include <algorithm>

namespace fumage {

static_assert(kMaxPresetBytes + kMaxLayers * 2 * base64Length(kMaxPictureBytes) <= kMaxPresetFileBytes,
    "a scene has more pictures than its file has room for: what is saved could not be read");

namespace {

/// What is written: the scene, or one of its layers.
struct Owner {
    const Preset& preset;
    Scope scope;
    std::size_t layer = 0;
    Effect effect; ///< the layer in its surroundings

    [[nodiscard]] std::string_view name() const { return scope == Scope::Scene ? kScene : kLayer; }
};

/// @param layer of the group, if it is a layer's
void writeUnknown(
    const Preset& preset, std::string_view group, std::size_t layer, std::string_view indent, std::string& out)
{
    for (const UnknownMember& member : preset.unknown) {
        if (member.group == group && member.layer == layer) {
            out += ",\n" + std::string(indent) + quoteJson(member.key) + ": " + member.json;
        }
    }
}

void writeLayerHeader(const Layer& layer, const std::string& indent, std::string& out)
{
    const auto write = [&](std::string_view key, const std::string& json) {
        out += "\n" + indent + quoteJson(key) + ": " + json + ",";
    };
    const auto flag = [](bool value) { return std::string(value ? "true" : "false"); };
    write(kLayerName, quoteJson(layer.name));
    write(kLayerVisible, flag(layer.visible));
    write(kLayerLocked, flag(layer.locked));
    write(kLayerTag, quoteJson(kColourTags[static_cast<std::size_t>(layer.tag)]));
    if (!layer.from.empty()) {
        write(kLayerFrom, quoteJson(layer.from));
    }
}

/// A list with an item a line; nothing where there is none.
void writeList(std::string_view key, const std::vector<std::string>& items, const std::string& indent, std::string& out)
{
    for (const std::string& item : items) {
        out += &item == items.data() ? "\n" + indent + quoteJson(key) + ": [\n" : ",\n";
        out += indent + "  " + item;
    }
    out += items.empty() ? "" : "\n" + indent + "],";
}

/// The markers of a scene.
void writeMarkers(const Preset& preset, const std::string& indent, std::string& out)
{
    std::vector<std::string> items;
    for (const Marker& marker : preset.scene.markers) {
        items.push_back(formatMarker(marker));
    }
    for (const UnknownMember& member : preset.unknown) {
        if (member.group == kMarkers) {
            items.push_back(member.json);
        }
    }
    writeList(kMarkers, items, indent, out);
}

/// What changes over time of a scene or of its layer; nothing where nothing does.
void writeAnimation(const Owner& owner, const std::string& indent, std::string& out)
{
    const bool isScene = owner.scope == Scope::Scene;
    const Scene& scene = owner.preset.scene;
    const Tracks& tracks = isScene ? scene.tracks : scene.layers[owner.layer].tracks;
    std::vector<std::string> items;
    for (const Track& track : tracks.all()) {
        items.push_back(formatTrack(track));
    }
    for (const UnknownMember& member : owner.preset.unknown) {
        if (member.group == kAnimation && member.isOfScene == isScene && (isScene || member.layer == owner.layer)) {
            items.push_back(member.json);
        }
    }
    writeList(kAnimation, items, indent, out);
}

/// The groups of a scene or of its layer, and what is unknown beside them.
void writeGroups(const Owner& owner, const std::string& indent, std::string& out)
{
    const Preset& preset = owner.preset;
    std::string_view group;
    writeAnimation(owner, indent, out);
    if (owner.scope == Scope::Scene) {
        writeMarkers(preset, indent, out);
    }
    for (const Parameter& parameter : parameterTable()) {
        if (parameter.scope != owner.scope) {
            continue;
        }
        if (parameter.group() != group) {
            if (!group.empty()) {
                writeUnknown(preset, group, owner.layer, indent + "  ", out);
                out += "\n" + indent + "},";
            }
            group = parameter.group();
            out += "\n" + indent + quoteJson(group) + ": {\n" + indent + "  ";
        } else {
            out += ",\n" + indent + "  ";
        }
        out += quoteJson(parameter.name()) + ": " + formatJson(parameter, parameter.get(owner.effect));
    }
    writeUnknown(preset, group, owner.layer, indent + "  ", out);
    out += "\n" + indent + "}";
    writeUnknown(preset, owner.name(), owner.layer, indent, out);
}

/// The preset that a picture carries.
Result<PresetReading> readPicture(const std::filesystem::path& path)
{
    const Result<OpenFile> file = OpenFile::open(path);
    if (!file) {
        return file.error();
    }
    const Result<ImageMetadata> notes =
        readImageMetadata([&](std::uint64_t at, std::size_t size) { return file.value().readAt(at, size); });
    if (!notes) {
        Error error = notes.error();
        error.place = path.string();
        return error;
    }
    if (notes.value().preset.empty()) {
        return Error{ErrorCode::WrongType, makeMessage("this picture carries no preset"), path.string(),
            makeMessage("Choose a PNG or EXR that Fumage has written, or the preset's own file")};
    }
    Result<PresetReading> reading = parsePreset(notes.value().preset, path.string());
    if (!reading) {
        Error error = reading.error();
        error.message = makeMessage("the preset that this picture carries cannot be read: %1", error.message);
        return error;
    }
    reading.value().frame = std::max(0, notes.value().frame);
    reading.value().sheet = notes.value().sheet;
    return reading;
}

} // namespace

Result<PresetReading> parsePreset(std::string_view json, const std::string& place)
{
    if (const std::optional<Error> error = presetTooLarge(json, place)) {
        return *error;
    }
    const Result<JsonNode> root = parseJsonOf(place, json);
    return root ? readPreset(json, root.value(), place) : Result<PresetReading>(root.error());
}

std::string formatPreset(const Preset& preset)
{
    std::string out = "{\n  \"format\": " + quoteJson(kPresetFormat)
        + ",\n  \"version\": " + std::to_string(kPresetVersion) + ",\n  \"name\": " + quoteJson(preset.name)
        + ",\n  \"description\": " + quoteJson(preset.description);
    out += ",\n  " + quoteJson(kScene) + ": {";
    writeGroups({preset, Scope::Scene, 0, preset.scene.effect()}, "    ", out);
    out += "\n  },\n  " + quoteJson(kLayers) + ": [";
    for (std::size_t layer = 0; layer < preset.scene.layers.size(); ++layer) {
        out += layer == 0 ? "\n    {" : ",\n    {";
        writeLayerHeader(preset.scene.layers[layer], "      ", out);
        writeGroups({preset, Scope::Layer, layer, preset.scene.effect(layer)}, "      ", out);
        out += "\n    }";
    }
    out += "\n  ]";
    writeUnknown(preset, "", 0, "  ", out);
    return out + "\n}\n";
}

std::string formatCarried(const Preset& preset)
{
    std::string json = formatPreset(preset);
    return asciiJson(json).size() <= kMaxNoteBytes ? json : std::string();
}

Result<PresetReading> readPresetFile(const std::filesystem::path& path)
{
    constexpr std::size_t kSignature = 8;
    if (const Result<std::string> begin = readFileHead(path, kSignature); begin && isPicture(begin.value())) {
        return readPicture(path);
    }
    const Result<std::string> text = readFile(path, kMaxPresetFileBytes);
    return text ? parsePreset(text.value(), path.string()) : Result<PresetReading>(text.error());
}

Status writePresetFile(const std::filesystem::path& path, const Preset& preset)
{
    return writeFileAtomically(path, formatPreset(preset));
}

} // namespace fumage
