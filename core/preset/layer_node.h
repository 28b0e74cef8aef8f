#pragma once

#include "core/preset/node_talk.h"
#include "core/scene/scene.h"

#include <string>

namespace fumage {

/// Reads a member of a layer that stands beside its groups: its name, its marks, and what it is born on.
/// @return whether the key is of one of them; else nothing was read
/// @error WrongType, TooLarge: what talk.error() makes of them
[[nodiscard]] Result<bool> readLayerMember(
    const std::string& key, const JsonNode& node, const NodeTalk& talk, Layer& layer);

} // namespace fumage
