#include "core/preset/library.h"

#include "core/base/text.h"
#include "core/preset/embedded_file.h"

#include <algorithm>
#include <cstdlib>

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
    const char* data = std::getenv("XDG_DATA_HOME");
    const char* home = std::getenv("HOME");
    std::filesystem::path base;
    if (data != nullptr && *data != '\0') {
        base = data;
    } else if (home != nullptr) {
        base = std::filesystem::path(home) / ".local" / "share";
    }
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
    return Error{ErrorCode::UnknownName, "there is no built-in preset " + inQuotes(entry.id), "", ""};
}

Result<PresetReading> loadPreset(const std::string& nameOrPath)
{
    std::vector<LibraryEntry> all = builtinPresets();
    const std::vector<LibraryEntry> user = presetsIn(userPresetFolder());
    all.insert(all.end(), user.begin(), user.end());
    std::vector<std::string_view> names;
    for (const LibraryEntry& entry : all) {
        if (entry.id == nameOrPath) {
            return loadPreset(entry);
        }
        names.push_back(entry.id);
    }
    std::error_code ignored;
    const bool looksLikeName = nameOrPath.find('/') == std::string::npos && nameOrPath.find('.') == std::string::npos;
    if (looksLikeName && !std::filesystem::exists(nameOrPath, ignored)) {
        const std::string_view near = nearestName(nameOrPath, names);
        return Error{ErrorCode::UnknownName, "there is no preset or file " + inQuotes(nameOrPath), "",
            near.empty() ? "List the presets with: fumage-cli presets" : "Did you mean " + inQuotes(near) + "?"};
    }
    return readPresetFile(nameOrPath);
}

} // namespace fumage
