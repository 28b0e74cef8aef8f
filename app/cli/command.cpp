#include "app/cli/command.h"

#include "core/base/text.h"
#include "core/effect/value.h"

#include <set>

namespace fumage::cli {

namespace {

Result<NamedEffect> load(const std::string& preset, const std::vector<std::string>& assignments)
{
    const Result<PresetReading> reading = readPreset(preset);
    if (!reading) {
        return reading.error();
    }
    for (const Message& warning : reading.value().warnings) {
        warn(warning.text());
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

/// Presets of one name in different folders would be written to the same files.
Status refuseSameNames(const std::vector<NamedEffect>& effects)
{
    std::set<std::string> names;
    for (const NamedEffect& named : effects) {
        if (!names.insert(named.name).second) {
            return Error{ErrorCode::OutOfRange, said("two presets are called %1, and one's files would overwrite the other's", inQuotes(named.name)), named.file.string(), said("Write them to different folders")};
        }
    }
    return Done{};
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
        return Error{ErrorCode::OutOfRange, said("several presets cannot be written to one file"), output, said("Name a folder, as in --output out/")};
    }
    std::vector<NamedEffect> effects;
    for (const std::string& preset : presets) {
        Result<NamedEffect> named = load(preset, assignments);
        if (!named) {
            return named.error();
        }
        effects.push_back(std::move(named.value()));
    }
    if (Status status = refuseSameNames(effects); !status) {
        return status;
    }
    for (const NamedEffect& named : effects) {
        if (Status status = work(named); !status) {
            return status;
        }
    }
    return Done{};
}

void addJson(CLI::App& command, bool& asJson)
{
    command.add_flag("--json", asJson, "Answer in JSON, for programs to read");
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
