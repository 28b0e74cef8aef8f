#include "app/cli/command.h"
#include "app/cli/json_answer.h"

#include "core/system/file.h"
#include "core/system/path.h"
#include "core/base/text.h"
#include "core/export/output_name.h"
#include "core/preset/library.h"
#include "core/preset/preset_file.h"

#include <algorithm>
#include <iomanip>
#include <memory>
#include <sstream>

namespace fumage::cli {

namespace {

void list(const std::vector<LibraryEntry>& entries, std::ostream& out)
{
    std::size_t width = 0;
    for (const LibraryEntry& entry : entries) {
        width = std::max(width, entry.id.size());
    }
    for (const LibraryEntry& entry : entries) {
        const Result<PresetReading> reading = loadPreset(entry);
        out << "  " << std::left << std::setw(static_cast<int>(width) + 2) << printable(entry.id)
            << printable(reading ? reading.value().preset.description : reading.error().text()) << "\n";
    }
}

Status presets()
{
    std::ostringstream out;
    out << "Built in:\n";
    list(builtinPresets(), out);
    const std::vector<LibraryEntry> user = presetsIn(userPresetFolder());
    if (userPresetFolder().empty()) {
        out << "Yours: there is no place for them, since the environment names none (XDG_DATA_HOME or HOME; on Windows "
               "APPDATA).\n";
        return print(out.str());
    }
    out << "Yours, in " << printable(userPresetFolder().string()) << ":\n";
    list(user, out);
    if (user.empty()) {
        out << "  none\n";
    }
    return print(out.str());
}

void listInto(nlohmann::ordered_json& all, const std::vector<LibraryEntry>& entries)
{
    for (const LibraryEntry& entry : entries) {
        const Result<PresetReading> reading = loadPreset(entry);
        nlohmann::ordered_json& one = all.emplace_back(
            nlohmann::ordered_json{{"id", entry.id}, {"file", entry.path.string()}, {"builtin", entry.path.empty()}});
        if (reading) {
            const Preset& preset = reading.value().preset;
            one.update(
                {{"name", preset.name}, {"description", preset.description}, {"loop", preset.scene.timeline.loop}});
        } else {
            one["error"] = reading.error().text();
        }
    }
}

Status presetsAsJson()
{
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    listInto(all, builtinPresets());
    listInto(all, presetsIn(userPresetFolder()));
    return printJson(all);
}

/// Prints the preset as canonical JSON: a start for one's own.
Status show(const std::string& name, const std::string& output)
{
    const Result<PresetReading> reading = readPreset(name);
    const Result<LibraryEntry> entry = findPreset(name);
    if (name != kStandardStream && output != kStandardStream && entry
        && isSameFile(entry.value().path, pathFrom(output))) {
        return wouldOverwrite(entry.value().path);
    }
    return reading ? writeOutput(output, formatPreset(reading.value().preset)) : Status(reading.error());
}

struct PresetOptions {
    std::string show;
    std::string output = "-";
    bool json = false;
};

Status run(const PresetOptions& options)
{
    if (!options.show.empty()) {
        return show(options.show, options.output);
    }
    return options.json ? presetsAsJson() : presets();
}

} // namespace

void addPresets(CLI::App& program, Action& action)
{
    auto options = std::make_shared<PresetOptions>();
    CLI::App* command = program.add_subcommand("presets", "List the presets, or print one as JSON");
    command->add_option("--show", options->show, "Print this preset as canonical JSON")->type_name("PRESET");
    command->add_option("-o,--output", options->output, "File for --show; - is standard output")
        ->type_name("FILE")
        ->capture_default_str();
    addJson(*command, options->json);
    command->callback([options, &action] { action = [options] { return run(*options); }; });
}

} // namespace fumage::cli
