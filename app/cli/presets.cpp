#include "app/cli/command.h"

#include "core/preset/library.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>

namespace fumage::cli {

namespace {

void list(const std::vector<LibraryEntry>& entries)
{
    std::size_t width = 0;
    for (const LibraryEntry& entry : entries) {
        width = std::max(width, entry.id.size());
    }
    for (const LibraryEntry& entry : entries) {
        const Result<PresetReading> reading = loadPreset(entry);
        std::cout << "  " << std::left << std::setw(static_cast<int>(width) + 2) << entry.id << (reading ? reading.value().preset.description : reading.error().text()) << "\n";
    }
}

Status presets()
{
    std::cout << "Built in:\n";
    list(builtinPresets());
    const std::vector<LibraryEntry> user = presetsIn(userPresetFolder());
    std::cout << "Yours, in " << userPresetFolder().string() << ":\n";
    list(user);
    if (user.empty()) {
        std::cout << "  none\n";
    }
    return Done{};
}

/// Prints the preset as canonical JSON: a start for one's own.
Status show(const std::string& name, const std::string& output)
{
    const Result<PresetReading> reading = loadPreset(name);
    return reading ? writeOutput(output, formatPreset(reading.value().preset)) : Status(reading.error());
}

struct PresetOptions {
    std::string show;
    std::string output = "-";
};

} // namespace

void addPresets(CLI::App& program, Action& action)
{
    auto options = std::make_shared<PresetOptions>();
    CLI::App* command = program.add_subcommand("presets", "List the presets, or print one as JSON");
    command->add_option("--show", options->show, "Print this preset as canonical JSON")->type_name("PRESET");
    command->add_option("-o,--output", options->output, "File for --show; - is standard output")->type_name("FILE")->capture_default_str();
    command->callback([options, &action] { action = [options] { return options->show.empty() ? presets() : show(options->show, options->output); }; });
}

} // namespace fumage::cli
