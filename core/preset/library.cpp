#include "core/preset/library.h"

#include "core/base/embedded_file.h"
#include "core/system/environment.h"
#include "core/system/path.h"
#include "core/base/text.h"
#include "core/preset/preset_file.h"

#include <algorithm>
#include <cassert>

namespace fumage {

extern const EmbeddedFile kBuiltinPresets[];
extern const std::size_t kBuiltinPresetsCount;

namespace {

std::span<const EmbeddedFile> embedded()
{
    return {kBuiltinPresets, kBuiltinPresetsCount};
}

void sortById(std::vector<LibraryEntry>& entries)
{
    std::sort(entries.begin(), entries.end(), [](const LibraryEntry& a, const LibraryEntry& b) { return a.id < b.id; });
}

} // namespace

std::vector<LibraryEntry> builtinPresets()
{
    std::vector<LibraryEntry> entries;
    for (const EmbeddedFile& file : embedded()) {
        entries.push_back({std::string(file.name), {}});
    }
    sortById(entries);
    return entries;
}

std::vector<LibraryEntry> presetsIn(const std::filesystem::path& folder)
{
    std::vector<LibraryEntry> entries;
    std::error_code failure;
    for (std::filesystem::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure)) {
        if (at->path().extension() == ".json") {
            entries.push_back({at->path().stem().string(), at->path()});
        }
    }
    sortById(entries);
    return entries;
}

std::filesystem::path userPresetFolder()
{
    const std::filesystem::path base = userDataFolder();
    return base.empty() ? base : base / "fumage" / "presets";
}

Result<PresetReading> loadPreset(const LibraryEntry& entry)
{
    if (!entry.path.empty()) {
        return readPresetFile(entry.path);
    }
    for (const EmbeddedFile& file : embedded()) {
        if (file.name == entry.id) {
            return parsePreset(file.contents, entry.id);
        }
    }
    return Error{ErrorCode::UnknownName, makeMessage("there is no built-in preset %1", inQuotes(entry.id)), {}, {}};
}

Preset newPreset()
{
    const Result<PresetReading> reading = loadPreset(LibraryEntry{"default", {}});
    assert(reading.ok());
    Preset preset;
    preset.scene = reading.value().preset.scene;
    return preset;
}

Result<LibraryEntry> findPreset(const std::string& nameOrPath)
{
    std::vector<LibraryEntry> all = builtinPresets();
    const std::vector<LibraryEntry> user = presetsIn(userPresetFolder());
    all.insert(all.end(), user.begin(), user.end());
    std::vector<std::string_view> names;
    for (const LibraryEntry& entry : all) {
        if (entry.id == nameOrPath) {
            return entry;
        }
        names.push_back(entry.id);
    }
    const std::filesystem::path file = pathFrom(nameOrPath);
    std::error_code ignored;
    const bool looksLikeName = !file.has_parent_path() && nameOrPath.find('.') == std::string::npos;
    if (looksLikeName && !std::filesystem::exists(std::filesystem::symlink_status(file, ignored))) {
        const std::string_view near = nearestName(nameOrPath, names);
        return Error{ErrorCode::UnknownName, makeMessage("there is no preset or file %1", inQuotes(nameOrPath)), {},
            near.empty() ? makeMessage("List the presets with: fumage-cli presets")
                         : makeMessage("Did you mean %1?", inQuotes(near))};
    }
    return LibraryEntry{file.stem().string(), file};
}

Result<PresetReading> loadPreset(const std::string& nameOrPath)
{
    const Result<LibraryEntry> entry = findPreset(nameOrPath);
    return entry ? loadPreset(entry.value()) : entry.error();
}

} // namespace fumage
