#pragma once

#include "core/base/result.h"
#include "core/effect/effect.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

inline constexpr std::string_view kPresetFormat = "fumage-preset";
inline constexpr int kPresetVersion = 1;
inline constexpr std::size_t kMaxPresetBytes = std::size_t{1} << 20U;

/// A member of the file that this version does not know; it is written back as it was.
struct UnknownMember {
    std::string group; ///< empty at the top level
    std::string key;
    std::string json; ///< its value, as in the file
};

/// An effect with its name, as it stands in a file.
struct Preset {
    std::string name;
    std::string description;
    Effect effect;
    std::vector<UnknownMember> unknown;
};

/// A preset that was read, and what the reader had to put right.
struct PresetReading {
    Preset preset;
    std::optional<int> frame; ///< that the picture shows which carries the preset; none: the file is the preset's own
    std::string sheet; ///< where that picture is a sheet: how its cells are made, as anybody may have written it
    std::vector<Message> warnings; ///< unknown keys with the nearest known one, clamped values, missing parameters; the first 20, then how many more
};

/// O(n log n) in the text.
/// @param place name of the source for messages, usually the file; may be empty
/// @error Syntax, NotUtf8, NotFinite, TooDeep, TooLarge, WrongType, WrongVersion, UnknownName; places have line and column
[[nodiscard]] Result<PresetReading> parsePreset(std::string_view json, const std::string& place = "");

/// Canonical JSON: fixed order, every value, shortest round-trip numbers, a newline at the end.
/// parsePreset() of it gives the same preset; writing that again gives the same text.
[[nodiscard]] std::string formatPreset(const Preset& preset);

/// Reads a preset, or the one that a picture carries: a PNG or EXR that Fumage has written.
/// @error those of readFile() with kMaxPresetBytes, of readPictureNotes(), and of parsePreset(); WrongType: a picture without a preset
[[nodiscard]] Result<PresetReading> readPresetFile(const std::filesystem::path& path);
/// Writes formatPreset(), whole or not at all.
/// @error those of writeFileAtomically()
[[nodiscard]] Status writePresetFile(const std::filesystem::path& path, const Preset& preset);

} // namespace fumage
