#pragma once

#include <glm/vec3.hpp>

namespace fumage {

/// Which axis points up in a file: ours is y; Blender, 3ds Max and Unreal have z.
enum class UpAxis {
    Y,
    Z,
};

/// A place or a way in a file's axes, which stay right-handed.
[[nodiscard]] inline glm::vec3 turned(const glm::vec3& v, UpAxis up)
{
    return up == UpAxis::Z ? glm::vec3(v.x, -v.z, v.y) : v;
}

} // namespace fumage
