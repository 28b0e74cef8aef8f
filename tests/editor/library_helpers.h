#pragma once

#include "core/preset/library.h"

namespace fumage::tests {

/// How many presets a list has that has read all of the library.
inline int sizeOfLibrary()
{
    return static_cast<int>(presetsIn(userPresetFolder()).size() + builtinPresets().size());
}

} // namespace fumage::tests
