#include "app/cli/command.h"
#include "app/cli/json_answer.h"

#include "core/base/simd.h"
#include "core/base/text.h"
#include "core/effect/parameter_table.h"
#include "core/effect/sampling.h"
#include "core/effect/value.h"
#include "core/preset/library.h"
#include "core/simulation/schedule.h"
#include "core/version.h"

#include <memory>
#include <sstream>

namespace fumage::cli {

namespace {

/// What the picture shows that the preset was read from; empty where it has a file of its own.
std::string shownText(const Shown& shown)
{
    if (shown.sheet) {
        return "shows       a sheet of " + std::to_string(shown.sheet->columns) + " x "
            + std::to_string(shown.sheet->rows) + " cells, frames " + textOf(shown.sheet->frames) + "\n";
    }
    return shown.frame ? "shows       frame " + std::to_string(*shown.frame) + "\n" : "";
}

/// Writes the moments that have names.
void writeMarkers(const Scene& scene, std::ostream& out)
{
    for (const Marker& marker : scene.markers) {
        out << (&marker == scene.markers.data() ? "markers     " : "            ") << formatDouble(marker.seconds)
            << " s  " << printable(marker.name) << "\n";
    }
}

/// What a parameter of a layer is called, as --set has it: with the layer's number where there are several.
std::string keyOf(const Scene& scene, const Parameter& parameter, std::size_t layer)
{
    const bool isNamed = scene.layers.size() > 1 && parameter.scope == Scope::Layer;
    return (isNamed ? std::to_string(layer + 1) + "/" : "") + std::string(parameter.key);
}

/// A parameter with key frames.
struct Animated {
    std::string key;
    std::size_t keys = 0;
};

/// Those of what all layers share, then those of each layer.
std::vector<Animated> animatedIn(const Scene& scene)
{
    std::vector<Animated> all;
    const auto add = [&](const Tracks& tracks, std::size_t layer) {
        for (const Track& track : tracks.all()) {
            all.push_back({keyOf(scene, *track.parameter, layer), track.keys.size()});
        }
    };
    add(scene.tracks, 0);
    for (std::size_t layer = 0; layer < scene.layers.size(); ++layer) {
        add(scene.layers[layer].tracks, layer);
    }
    return all;
}

void writeAnimated(const Scene& scene, std::ostream& out)
{
    const std::vector<Animated> all = animatedIn(scene);
    if (all.empty()) {
        return;
    }
    out << "key frames  " << all.size()
        << (all.size() == 1 ? " parameter changes over time:" : " parameters change over time:");
    for (const Animated& each : all) {
        out << (&each == all.data() ? " " : ", ") << each.key << " (" << each.keys << ")";
    }
    out << "\n";
}

Status asText(const Preset& preset, const Shown& shown)
{
    const Scene& scene = preset.scene;
    std::ostringstream out;
    out << printable(preset.name) << "\n" << printable(preset.description) << "\n\n";
    const bool several = scene.layers.size() > 1;
    for (std::size_t layer = 0; layer < scene.layers.size(); ++layer) {
        const Schedule schedule = makeSchedule(sampledLayer(scene, layer));
        out << (several ? "layer " + std::to_string(layer + 1) + "     " + printable(scene.layers[layer].name)
                    + (scene.layers[layer].visible ? "" : " (muted)")
                    + (scene.layers[layer].from.empty() ? "" : ", born on " + printable(scene.layers[layer].from))
                    + "\n"
                        : "");
        out << "particles   " << schedule.capacity() << " at most, each living "
            << static_cast<float>(schedule.lifetimeSteps) * schedule.dt << " s\n";
    }
    out << "timeline    " << scene.timeline.length << " frames at " << scene.timeline.frameRate << " fps"
        << (scene.timeline.loop ? ", looping" : "") << "\n";
    writeMarkers(scene, out);
    writeAnimated(scene, out);
    out << "picture     " << scene.output.width << " x " << scene.output.height << " pixels\n"
        << shownText(shown) << "\n";
    out << "What differs from a new document:\n";
    for (std::size_t layer = 0; layer < scene.layers.size(); ++layer) {
        const Effect effect = scene.effect(layer);
        for (const Parameter* parameter : differences(effect, Effect{})) {
            if (layer == 0 || parameter->scope == Scope::Layer) {
                out << "  " << keyOf(scene, *parameter, layer) << " = "
                    << formatText(*parameter, parameter->get(effect), true) << "\n";
            }
        }
    }
    return print(out.str());
}

/// The same for programs.
void addTime(const Scene& scene, nlohmann::ordered_json& answer)
{
    answer["markers"] = nlohmann::ordered_json::array();
    for (const Marker& marker : scene.markers) {
        answer["markers"].push_back({{"name", marker.name}, {"seconds", marker.seconds}});
    }
    answer["animated"] = nlohmann::ordered_json::array();
    for (const Animated& each : animatedIn(scene)) {
        answer["animated"].push_back({{"key", each.key}, {"keyFrames", each.keys}});
    }
}

nlohmann::ordered_json asJson(const Preset& preset, const Schedule& schedule)
{
    const Scene& scene = preset.scene;
    const JsonValues values(preset);
    auto changed = nlohmann::ordered_json::object();
    for (const Parameter* parameter : differences(scene.effect(), Effect{})) {
        changed[std::string(parameter->key)] = values.of(*parameter);
    }
    auto layers = nlohmann::ordered_json::array();
    for (std::size_t layer = 0; layer < scene.layers.size(); ++layer) {
        auto own = nlohmann::ordered_json::object();
        for (const Parameter* parameter : differences(scene.effect(layer), Effect{})) {
            if (parameter->scope == Scope::Layer) {
                own[std::string(parameter->key)] = values.of(*parameter, layer);
            }
        }
        layers.push_back({{"name", scene.layers[layer].name}, {"visible", scene.layers[layer].visible},
            {"from", scene.layers[layer].from}, {"particles", makeSchedule(sampledLayer(scene, layer)).capacity()},
            {"changed", own}});
    }
    return {{"name", preset.name}, {"description", preset.description}, {"particles", schedule.capacity()},
        {"lifetime", static_cast<float>(schedule.lifetimeSteps) * schedule.dt}, {"frames", scene.timeline.length},
        {"frameRate", scene.timeline.frameRate}, {"loop", scene.timeline.loop}, {"width", scene.output.width},
        {"height", scene.output.height}, {"changed", changed}, {"layers", layers}};
}

Status info(const std::string& name, bool json)
{
    const Result<PresetReading> reading = readPreset(name);
    if (!reading) {
        return reading.error();
    }
    const Preset& preset = reading.value().preset;
    const Schedule schedule = makeSchedule(sampledLayer(preset.scene, 0));
    const Shown shown = shownBy(reading.value());
    if (!json) {
        return asText(preset, shown);
    }
    nlohmann::ordered_json answer = asJson(preset, schedule);
    addTime(preset.scene, answer);
    if (shown.frame) {
        answer["frame"] = *shown.frame;
    }
    if (shown.sheet) {
        answer["sheet"] = {
            {"columns", shown.sheet->columns}, {"rows", shown.sheet->rows}, {"frames", textOf(shown.sheet->frames)}};
    }
    return printJson(answer);
}

Status machineAsJson()
{
    return printJson({{"version", FUMAGE_VERSION}, {"instructionSets", availableSimdTargets()},
        {"userPresets", userPresetFolder().string()}});
}

Status machine()
{
    std::ostringstream out;
    out << "fumage-cli " << FUMAGE_VERSION << "\ninstruction sets, best first:";
    for (const std::string& name : availableSimdTargets()) {
        out << ' ' << name;
    }
    out << "\nuser presets: " << userPresetFolder().string() << "\n";
    return print(out.str());
}

} // namespace

void addInfo(CLI::App& program, Action& action)
{
    struct Options {
        std::string preset;
        bool json = false;
    };
    auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("info", "Show what a preset is, or without one what this machine has");
    command->add_option("preset", options->preset, "Name or file")->type_name("PRESET");
    addJson(*command, options->json);
    command->callback([options, &action] {
        action = [options] {
            if (options->preset.empty()) {
                return options->json ? machineAsJson() : machine();
            }
            return info(options->preset, options->json);
        };
    });
}

} // namespace fumage::cli
