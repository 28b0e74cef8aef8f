#pragma once

#include "core/preset/json_tree.h"
#include "core/preset/preset.h"

namespace fumage {

/// More warnings are counted only: nobody reads them, and a hostile file has a hundred thousand.
inline constexpr std::size_t kMaxWarnings = 20;

/// What is said of one that has more than kMaxPresetBytes, or kMaxPresetFileBytes with its pictures; nothing of others.
[[nodiscard]] std::optional<Error> presetTooLarge(std::string_view json, const Message& place);

/// Reads a preset that stands in a file among other things.
/// @param text         the whole file, in which messages tell lines and columns
/// @param root         the preset
/// @param mostWarnings as parsePreset() has kMaxWarnings
/// @error those of parsePreset()
[[nodiscard]] Result<PresetReading> readPreset(
    std::string_view text, const JsonNode& root, const std::string& place, std::size_t mostWarnings = kMaxWarnings);

} // namespace fumage
