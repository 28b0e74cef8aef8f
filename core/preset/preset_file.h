#pragma once

#include "core/image_io/metadata_reader.h"
#include "core/preset/preset.h"

#include <filesystem>

namespace fumage {

/// Reads presets of all versions up to kPresetVersion, see migratePreset(). O(n log n) in the text.
/// @param place name of the source for messages, usually the file; may be empty
/// @error Syntax, NotUtf8, NotFinite, TooDeep, TooLarge, WrongType, WrongVersion, UnknownName; places have line and
/// column
[[nodiscard]] Result<PresetReading> parsePreset(std::string_view json, const std::string& place = "");

/// Canonical JSON: fixed order, every value, shortest round-trip numbers, a newline at the end.
/// parsePreset() of it gives the same preset; writing that again gives the same text.
[[nodiscard]] std::string formatPreset(const Preset& preset);

/// formatPreset() for pictures to carry; empty where it is longer than they can: nobody would read it.
[[nodiscard]] std::string formatCarried(const Preset& preset);

/// Reads a preset, or the one that a picture carries: a PNG or EXR that Fumage has written.
/// @error those of readFile() with kMaxPresetFileBytes, of readImageMetadata(), and of parsePreset(); WrongType: a
/// picture without a preset
[[nodiscard]] Result<PresetReading> readPresetFile(const std::filesystem::path& path);
/// Writes formatPreset(), whole or not at all.
/// @error those of writeFileAtomically()
[[nodiscard]] Status writePresetFile(const std::filesystem::path& path, const Preset& preset);

} // namespace fumage
