#pragma once

#include "core/scene/scene.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// How the layers of a scene are written.
enum class LayerOutput {
    Together, ///< one picture of all
    Alone, ///< one each: in the air and the light that all have, with nothing before or behind it
    Contribution, ///< one each: what it gives to the picture, the others hiding what they hide; they add up to it
    Stacked, ///< one each: drawn over one another in their order they make the picture
};
inline constexpr std::size_t kLayerOutputs = 4;
/// "together", "alone", "contribution", "stacked".
[[nodiscard]] std::string_view nameOf(LayerOutput output);

/// Whether what is written of a layer has a sense beside the others alone: contributions and what is stacked.
[[nodiscard]] bool isShare(LayerOutput output);

/// In which numbers somebody adds and blends pictures whose colours are sRGB.
enum class BlendSpace {
    Encoded, ///< as they are stored: browsers, 2D engines, Godot's Compatibility renderer
    Linear, ///< decoded, as light: Unity and Unreal, Godot's Forward+
};
inline constexpr std::size_t kBlendSpaces = 2;
/// "encoded", "linear".
[[nodiscard]] std::string_view nameOf(BlendSpace space);

/// A layer that is written by itself.
struct WrittenLayer {
    std::size_t index = 0; ///< in the scene
    std::string name; ///< as the scene has it; may be empty
    std::string word; ///< the part of names of files, which no other layer has: "flames"
};

/// The layers of a scene that are seen, in their order; where none is, the first, as sampledLayers() has it. Words have
/// small letters, digits and -, and letters beyond ASCII; never _, which stands before the names of passes. Without a
/// letter it is "layer-2", by the number in the scene. What would be the same name anywhere, whatever its case, gets
/// that number at its end.
[[nodiscard]] std::vector<WrittenLayer> writtenLayers(const Scene& scene);

} // namespace fumage
