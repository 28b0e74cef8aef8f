#include "app/cli/command.h"

#include "core/effect/value.h"

namespace fumage::cli {

namespace {

Result<NamedEffect> load(const std::string& preset, const std::vector<std::string>& assignments)
{
    const Result<PresetReading> reading = readPreset(preset);
    if (!reading) {
        return reading.error();
    }
    for (const std::string& warning : reading.value().warnings) {
        warn(warning);
    }
    NamedEffect named{reading.value().preset.effect, "smoke", {}};
    if (preset != kStandardStream) {
        const Result<LibraryEntry> entry = findPreset(preset);
        named.name = entry ? entry.value().id : named.name;
        named.file = entry ? entry.value().path : named.file;
    }
    for (const std::string& assignment : assignments) {
        const Result<bool> clamped = applyAssignment(named.effect, assignment);
        if (!clamped) {
            Error error = clamped.error();
            error.place = "--set " + assignment;
            return error;
        }
        if (clamped.value()) {
            warn("--set " + assignment + ": out of range, the nearest allowed value is used");
        }
    }
    return named;
}

} // namespace

void EffectOptions::addTo(CLI::App& command)
{
    command.add_option("preset", presets, "Presets: names (see 'fumage-cli presets'), JSON files, or - for standard input")->required()->type_name("PRESET")->option_text("PRESET...");
    command.add_option("-s,--set", assignments, "Change a parameter, for example --set motion.wind=1.5; may be repeated")->type_name("KEY=VALUE")->take_all()->allow_extra_args(false)->option_text("KEY=VALUE");
}

Status EffectOptions::forEach(const std::string& output, const std::function<Status(const NamedEffect&)>& work) const
{
    std::error_code missing;
    const bool isFolder = output.empty() || output.ends_with('/') || std::filesystem::is_directory(output, missing);
    if (presets.size() > 1 && !isFolder) {
        return Error{ErrorCode::OutOfRange, "several presets cannot be written to one file", output, "Name a folder, as in --output out/"};
    }
    for (const std::string& preset : presets) {
        const Result<NamedEffect> named = load(preset, assignments);
        if (!named) {
            return named.error();
        }
        if (Status status = work(named.value()); !status) {
            return status;
        }
    }
    return Done{};
}

Result<PresetReading> readPreset(const std::string& name)
{
    if (name != kStandardStream) {
        return loadPreset(name);
    }
    const Result<std::string> text = readStandardInput(kMaxPresetBytes);
    return text ? parsePreset(text.value(), "standard input") : text.error();
}

} // namespace fumage::cli
