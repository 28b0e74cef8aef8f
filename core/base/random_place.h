#pragma once

#include "core/base/hash.h"

#include <glm/vec3.hpp>

namespace fumage {

/// A place in the unit cube, evenly random.
/// @param first of the three streams of the key that it takes
[[nodiscard]] inline glm::vec3 randomInUnitCube(std::uint32_t key, std::uint32_t first)
{
    return {unitFloat(streamBits(key, first)), unitFloat(streamBits(key, first + 1)),
        unitFloat(streamBits(key, first + 2))};
}

} // namespace fumage
