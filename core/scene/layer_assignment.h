#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

#include <string_view>

namespace fumage {

/// The layer that a name or a number from 1 stands for, as findLayer(). Where there is none, the one layer whose name
/// it is but for A to Z being small or not.
/// @error UnknownName where there is no such layer, with the names that there are, or several have the name
[[nodiscard]] Result<std::size_t> layerNamed(const Scene& scene, std::string_view name);

/// An assignment and the layer that it is for.
struct LayerAssignment {
    std::size_t layer = 0;
    std::string_view assignment; ///< "key=value"
};

/// Takes "flames/motion.drag=1" apart: a layer's name or its number from 1, and what is assigned in it. Without a slash
/// it is for the first layer.
/// @error UnknownName where there is no such layer, or several have the name
[[nodiscard]] Result<LayerAssignment> layerAssignment(const Scene& scene, std::string_view text);

/// Parses "key=value" or "layer/key=value" and applies it, as --set does. What all layers share is set in the scene,
/// whatever layer is named. "layer/from=name" lets a layer be born on another's particles, whose name is found whatever
/// its capital letters, too; "layer/from=" on its emitter.
/// @return whether the value had to be clamped
/// @error that of layerAssignment(), those of applyAssignment() and checkParent()
[[nodiscard]] Result<bool> applyToScene(Scene& scene, std::string_view text);

/// Mutes layers, or all but them, as --mute and --layers do.
/// @param names "flames,2": names or numbers, with commas between
/// @error that of layerNamed(); UnknownName where nothing is named
[[nodiscard]] Status showOnly(Scene& scene, std::string_view names);
[[nodiscard]] Status mute(Scene& scene, std::string_view names);

} // namespace fumage
