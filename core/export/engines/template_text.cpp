#include "core/export/engines/template_text.h"

#include "core/export/engines/engine_remarks.h"
#include "core/export/templates/template_facts.h"
#include "core/rendering/camera.h"
#include "core/rendering/view_transform.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>
#include <utility>

#include <glm/geometric.hpp>

namespace fumage {

extern const EmbeddedFile kEngineTemplates[];
extern const std::size_t kEngineTemplatesCount;

namespace {

constexpr std::array<std::pair<std::string_view, Language>, 11> kLanguages{{
    {"unity_editor", Language::CSharp},
    {"unreal_import", Language::Python},
    {"godot_scene", Language::Godot},
    {"godot_shader", Language::Godot},
    {"godot_import", Language::Godot},
    {"godot3_scene", Language::Godot},
    {"godot3_shader", Language::Godot},
    {"godot3_import", Language::Godot},
    {"effekseer_project", Language::Xml},
    {"defold_tilesource", Language::Protobuf},
    {"web_page", Language::Html},
}};

/// What a picture is to an engine that imports it.
TemplateFacts pictureFacts(Language language, const EnginePicture& picture)
{
    TemplateFacts facts(language);
    facts.text("file", picture.file.filename().string());
    facts.flag("srgb", picture.isSrgb);
    facts.flag("linear", !picture.isSrgb);
    facts.flag("exact", picture.isExact);
    return facts;
}

/// "a.r": the channel that a direction's light lies in.
void addChannels(const PassStyle& style, TemplateFacts& facts)
{
    const auto maps = channelsOf(style.layout);
    for (std::size_t map = 0; map < maps.size(); ++map) {
        for (std::size_t i = 0; i < 4; ++i) {
            facts.word("channel_" + std::string(nameOf(maps[map][i])), std::string(map == 0 ? "a." : "b.") + "rgba"[i]);
        }
    }
}

/// How large a cell is in the world, m, and where its middle lies, seen from the first emitter.
void addPlace(const Scene& scene, TemplateFacts& facts)
{
    const View view = makeView(scene.camera, 0.0F, scene.output.width, scene.output.height);
    const glm::vec3& source = scene.layers.front().emitter.position;
    const glm::vec3 looked = scene.camera.mode == CameraMode::Orbit ? scene.camera.target : source;
    const float depth = std::max(kNear, glm::dot(looked - view.eye, view.forward));
    const glm::vec3 middle = view.eye + depth * view.forward - source;
    const float width = static_cast<float>(view.width) / view.focal * depth;
    const float height = static_cast<float>(view.height) / view.focal * depth;
    facts.number("metres_wide", width);
    facts.number("metres_high", height);
    facts.number("half_metres", 0.5F * std::max(width, height));
    facts.number("metres", std::max(width, height));
    facts.number("middle_x", middle.x);
    facts.number("middle_y", middle.y);
    facts.number("middle_z", middle.z);
}

void addPictures(const EngineSheet& sheet, TemplateFacts& facts)
{
    std::vector<TemplateFacts> list;
    int index = 2; // resources of a Godot scene: the shader is the first
    PassSet passes;
    for (const EnginePicture& picture : sheet.pictures) {
        TemplateFacts each = pictureFacts(facts.language(), picture);
        each.number("index", index);
        each.bytes("bytes", picture.bytes);
        if (picture.pass) {
            const std::string key = fileNameOf(*picture.pass);
            each.flag(key, true);
            facts.flag("has_" + key, true);
            facts.number("index_" + key, index);
            facts.text("file_" + key, picture.file.filename().string());
            passes.add(*picture.pass);
        }
        list.push_back(std::move(each));
        ++index;
    }
    facts.list("pictures", std::move(list));
    const bool lit = passes.has(Pass::SixWayA) && passes.has(Pass::SixWayB);
    facts.flag("six_way", lit);
    facts.flag("unlit", !lit);
    facts.flag("misread", passes.has(Pass::Motion) && sheet.columns != sheet.rows);
}

/// Layers that are drawn over one another.
void addLayers(const EngineSheet& sheet, TemplateFacts& facts)
{
    std::vector<TemplateFacts> list;
    for (std::size_t i = 0; sheet.isStacked && i < sheet.pictures.size(); ++i) {
        const EnginePicture& picture = sheet.pictures[i];
        TemplateFacts each = pictureFacts(facts.language(), picture);
        each.text("name", picture.layer.empty() ? picture.file.stem().string() : picture.layer);
        each.identifier("id", picture.file.stem().string());
        each.number("number", static_cast<int>(i) + 1);
        each.number("index", static_cast<int>(i) + 2); // as in the list of pictures
        each.bytes("bytes", picture.bytes);
        list.push_back(std::move(each));
    }
    facts.list("layers", std::move(list));
    facts.flag("stacked", sheet.isStacked);
    facts.flag("stacked_encoded", sheet.isStacked && sheet.space == BlendSpace::Encoded);
}

/// What is drawn one after the other, each with a picture: the layers, or the colour alone.
void addNodes(const EngineSheet& sheet, const std::string& stem, TemplateFacts& facts)
{
    std::vector<TemplateFacts> list;
    for (const EnginePicture& picture : sheet.pictures) {
        if (sheet.isStacked || picture.pass == Pass::Colour) {
            TemplateFacts each = pictureFacts(facts.language(), picture);
            each.text("name",
                sheet.isStacked && !picture.layer.empty() ? picture.layer
                    : sheet.isStacked                     ? picture.file.stem().string()
                                                          : stem);
            list.push_back(std::move(each));
        }
    }
    facts.list("nodes", std::move(list));
}

TemplateFacts eventFacts(Language language, const SheetEvent& event)
{
    TemplateFacts facts(language);
    facts.text("name", event.name);
    facts.number("seconds", event.seconds);
    facts.number("cell", event.cell);
    return facts;
}

/// Events as tracks of an animation of Godot take them, in order: of keys that are as good as at one time a track keeps
/// the last alone. Source: Animation::_insert() and Math::is_equal_approx(), which is 1e-5 or that share of the time.
std::vector<std::vector<SheetEvent>> eventTracks(const std::vector<SheetEvent>& events)
{
    constexpr double kApart = 4e-5; // what is written has the precision of floats
    std::vector<std::vector<SheetEvent>> tracks;
    for (const SheetEvent& event : events) {
        const double apart = kApart * std::max(1.0, event.seconds);
        const auto takes = [&](const std::vector<SheetEvent>& track) {
            return track.back().seconds + apart <= event.seconds;
        };
        const auto track = std::ranges::find_if(tracks, takes);
        if (track == tracks.end()) {
            tracks.push_back({event});
        } else {
            track->push_back(event);
        }
    }
    return tracks;
}

/// Markers, as they are passed.
void addEvents(const EngineSheet& sheet, TemplateFacts& facts)
{
    const auto listOf = [&](const std::vector<SheetEvent>& events) {
        std::vector<TemplateFacts> list;
        std::ranges::transform(events, std::back_inserter(list),
            [&](const SheetEvent& event) { return eventFacts(facts.language(), event); });
        return list;
    };
    std::vector<TemplateFacts> tracks;
    for (const std::vector<SheetEvent>& track : eventTracks(sheet.events)) {
        tracks.emplace_back(facts.language());
        tracks.back().number("track", static_cast<int>(tracks.size()) - 1);
        tracks.back().list("events", listOf(track));
    }
    facts.flag("has_events", !sheet.events.empty());
    facts.list("events", listOf(sheet.events));
    facts.list("event_tracks", std::move(tracks));
}

/// How many resources a scene of Godot has, itself among them.
/// @param eventResources that markers need
int resourcesOf(const EngineSheet& sheet, bool glows, int eventResources)
{
    const auto pictures = static_cast<int>(sheet.pictures.size());
    // Shader and process; a material and a quad for each that is drawn.
    const int drawn = sheet.isStacked ? pictures : 1;
    const int glow = glows ? 2 : 0; // gradient and its texture
    return pictures + 2 + 2 * drawn + glow + (sheet.events.empty() ? 0 : eventResources) + 1;
}

TemplateFacts stopOf(Language language, float position, const glm::vec3& colour)
{
    TemplateFacts stop(language);
    stop.number("at", position);
    stop.number("red", colour.r);
    stop.number("green", colour.g);
    stop.number("blue", colour.b);
    return stop;
}

/// What makes colours of the map that says how much smoke glows, where there is such a map and it is not empty.
/// @return whether there is
bool addGlow(const EngineSheet& sheet, TemplateFacts& facts)
{
    const auto isMap = [](const EnginePicture& picture) { return picture.pass == Pass::SixWayB; };
    const bool hasMap = std::any_of(sheet.pictures.begin(), sheet.pictures.end(), isMap)
        && channelsOf(sheet.style.layout)[1][3] == SixWayChannel::Emissive;
    const bool glows = hasMap && sheet.scales.glow > 0.0F;
    std::vector<TemplateFacts> keys;
    for (int k = 0; k < kGlowKeys; ++k) {
        keys.push_back(
            stopOf(facts.language(), glowKeyPosition(k), sheet.scales.ramp.colours[static_cast<std::size_t>(k)]));
    }
    // Where gradients are joined in sRGB, more stops than keys keep what is linear between these.
    constexpr int kStops = 3 * (kGlowKeys - 1);
    std::vector<TemplateFacts> stops;
    for (int i = 0; i <= kStops; ++i) {
        const float position = static_cast<float>(i) / kStops;
        const glm::vec3 colour = glowColour(sheet.scales.ramp, position);
        stops.push_back(stopOf(facts.language(), position,
            {srgbFromLinear(colour.r), srgbFromLinear(colour.g), srgbFromLinear(colour.b)}));
    }
    facts.flag("glows", glows);
    facts.number("glow_scale", sheet.scales.glow);
    facts.list("glow_keys", std::move(keys));
    facts.list("glow_stops", std::move(stops));
    return glows;
}

void addGrid(const EngineSheet& sheet, TemplateFacts& facts)
{
    const Output& cell = sheet.scene.output;
    const int cells = sheet.columns * sheet.rows;
    facts.number("columns", sheet.columns);
    facts.number("rows", sheet.rows);
    facts.number("cells", cells);
    facts.number("last_cell", cells - 1);
    facts.number("cell_width", cell.width);
    facts.number("cell_height", cell.height);
    facts.number("largest_edge", std::max(cell.width * sheet.columns, cell.height * sheet.rows));
}

void addTime(const EngineSheet& sheet, TemplateFacts& facts)
{
    const int cells = sheet.columns * sheet.rows;
    facts.number("cells_per_second", sheet.cellsPerSecond);
    facts.number("whole_cells_per_second", static_cast<int>(playedRate(Engine::Defold, sheet.cellsPerSecond)));
    facts.number("seconds", cells / sheet.cellsPerSecond);
    const int sixtieths = static_cast<int>(60.0 / playedRate(Engine::Effekseer, sheet.cellsPerSecond) + 0.5);
    facts.number("sixtieths", sixtieths);
    facts.number("life_sixtieths", sixtieths * cells);
    facts.flag("loop", sheet.loops);
    facts.flag("once", !sheet.loops);
}

TemplateFacts factsOf(Language language, const EngineSheet& sheet)
{
    const std::string stem = (sheet.named.empty() ? sheet.pictures.front().file : sheet.named).stem().string();
    TemplateFacts facts(language);
    facts.text("name", stem);
    facts.label("label", stem);
    facts.identifier("id", stem);
    addGrid(sheet, facts);
    addTime(sheet, facts);
    facts.number("motion_scale", sheet.scales.motion);
    facts.word("motion_right", sheet.style.vectors == VectorSigns::Unity ? "1.0" : "-1.0");
    facts.word("signs", nameOf(sheet.style.vectors));
    facts.word("green", sheet.style.normals == NormalGreen::OpenGl ? "up" : "down");
    facts.word("layout", nameOf(sheet.style.layout));
    facts.number("light_scale", sheet.scales.light);
    addPictures(sheet, facts);
    addLayers(sheet, facts);
    addNodes(sheet, stem, facts);
    const bool glows = addGlow(sheet, facts);
    addEvents(sheet, facts);
    facts.number("resources", resourcesOf(sheet, glows, 3)); // script, animation and its library
    facts.number("resources_godot3", resourcesOf(sheet, glows, 2)); // which has no libraries
    addChannels(sheet.style, facts);
    addPlace(sheet.scene, facts);
    return facts;
}

std::string filled(std::string_view name, const TemplateFacts& facts)
{
    const EmbeddedFile* const found = findEmbedded({kEngineTemplates, kEngineTemplatesCount}, name);
    assert(found != nullptr);
    return facts.fill(*found);
}

} // namespace

Language languageOfTemplate(std::string_view name)
{
    const auto found =
        std::find_if(kLanguages.begin(), kLanguages.end(), [&](const auto& each) { return each.first == name; });
    assert(found != kLanguages.end());
    return found->second;
}

std::string sheetText(std::string_view name, const EngineSheet& sheet)
{
    return filled(name, factsOf(languageOfTemplate(name), sheet));
}

std::string importText(std::string_view name, const EnginePicture& picture)
{
    return filled(name, pictureFacts(languageOfTemplate(name), picture));
}

} // namespace fumage
