#pragma once

#include "core/preset/preset_file.h"

namespace fumage {

/// Where a preset of the library comes from.
struct LibraryEntry {
    std::string id; ///< "chimney": the file's name without ending; what is made of the preset may be named after it
    std::filesystem::path path; ///< empty where it is built in
};

/// The presets that are compiled into the library, in alphabetical order.
[[nodiscard]] std::vector<LibraryEntry> builtinPresets();

/// The presets in a folder; a folder that is not there has none.
[[nodiscard]] std::vector<LibraryEntry> presetsIn(const std::filesystem::path& folder);

/// fumage/presets in userDataFolder(). Only absolute folders count, as the XDG Base Directory Specification says; empty
/// if there is none.
[[nodiscard]] std::filesystem::path userPresetFolder();

/// @error those of readPresetFile()
[[nodiscard]] Result<PresetReading> loadPreset(const LibraryEntry& entry);

/// What a new document shows: the effect of the built-in preset "default", which has no name yet.
[[nodiscard]] Preset newPreset();

/// Finds what a person names: a built-in preset, else one of the user's folder, else a file, which need not be there.
/// @error UnknownName with the nearest name
[[nodiscard]] Result<LibraryEntry> findPreset(const std::string& nameOrPath);

/// Loads what findPreset() finds.
[[nodiscard]] Result<PresetReading> loadPreset(const std::string& nameOrPath);

} // namespace fumage
