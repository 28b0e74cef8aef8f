#pragma once

#include "core/preset/json_tree.h"

namespace fumage {

/// Brings the tree of a preset that an earlier version of the format has to the form of kPresetVersion, one version
/// after the other. Values keep their place in the text, so that messages about them name where they stand; what no
/// version knows is kept beside what it stood beside.
/// @param root    an object
/// @param version that it was written in, 1 to kPresetVersion
/// O(members)
void migratePreset(JsonNode& root, int version);

} // namespace fumage
