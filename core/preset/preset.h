#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

inline constexpr std::string_view kPresetFormat = "fumage-preset";
inline constexpr int kPresetVersion = 2;
/// Most bytes of a preset without its pictures, and of its file: each layer has room for its pictures.
inline constexpr std::size_t kMaxPresetBytes = std::size_t{1} << 20U;
inline constexpr std::size_t kMaxPresetFileBytes = std::size_t{64} << 20U;

/// A member of the file that this version does not know; it is written back as it was.
struct UnknownMember {
    std::string group; ///< beside whose members it stands; "scene" or "layer": beside their groups; "animation" and
                       ///< "markers": among the tracks or markers; empty: at the top level
    std::string key;
    std::string json; ///< its value, as in the file
    std::size_t layer = 0; ///< that its group belongs to, if it is a layer's
    bool isOfScene = false; ///< a track that is none of a layer's
};

/// A scene with its name, as it stands in a file.
struct Preset {
    std::string name;
    std::string description;
    Scene scene;
    std::vector<UnknownMember> unknown;
};

/// A preset that was read, and what the reader had to put right.
struct PresetReading {
    Preset preset;
    std::optional<int> frame; ///< that the picture shows which carries the preset; none: the file is the preset's own
    std::string sheet; ///< where that picture is a sheet: how its cells are made, as anybody may have written it
    std::vector<Message> warnings; ///< unknown keys with the nearest known one, clamped values, missing parameters; the
                                   ///< first 20, then how many more
};

} // namespace fumage
