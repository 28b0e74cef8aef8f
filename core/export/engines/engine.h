#pragma once

#include "core/export/image_file.h"
#include "core/export/layer_output.h"
#include "core/export/pass_picture.h"

#include <array>
#include <string_view>

namespace fumage {

/// What plays a flipbook, and what is therefore written beside it.
enum class Engine {
    Generic, ///< the side-car alone
    Unity, ///< import script that sets up textures and makes a particle system
    Unreal, ///< Python script that imports the textures with their settings
    Godot, ///< Godot 4: scene and shader with blended cells, motion vectors and six-way light
    Godot3, ///< the same without six-way light
    Effekseer, ///< project with one node, or one a layer
    Pixi, ///< TexturePacker's JSON, which PixiJS and Phaser read
    Defold, ///< tile source
    Web, ///< a page that plays the sheet and needs nothing else
};
inline constexpr std::size_t kEngines = 9;

/// All of them, in the order in which they are told.
inline constexpr std::array<Engine, kEngines> kAllEngines{Engine::Generic, Engine::Unity, Engine::Unreal, Engine::Godot,
    Engine::Godot3, Engine::Effekseer, Engine::Pixi, Engine::Defold, Engine::Web};

/// "generic", "godot3": what command lines call it.
[[nodiscard]] std::string_view nameOf(Engine engine);
/// "Godot 3": the name that its makers gave it; of the generic one: empty.
[[nodiscard]] std::string_view titleOf(Engine engine);

/// The passes that an engine makes something of without being asked.
[[nodiscard]] PassSet passesFor(Engine engine);
/// In which numbers an engine blends, as it is set up at first: 3D engines as light.
[[nodiscard]] BlendSpace blendSpaceOf(Engine engine);
/// Whether an engine draws a picture over what is behind it as alpha * colour + (1 - alpha) * behind, and in no other
/// way; others do as colour + (1 - alpha) * behind, too.
[[nodiscard]] bool blendsStraight(Engine engine);
/// The signs and channels that an engine reads. Light in EXR is premultiplied, as its colours are; in PNG straight.
[[nodiscard]] PassStyle styleFor(Engine engine, ImageFormat format);

} // namespace fumage
