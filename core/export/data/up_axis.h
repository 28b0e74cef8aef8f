#pragma once

#include <array>
#include <string_view>

#include <glm/vec3.hpp>

namespace fumage {

/// Which axis points up in a file: ours is y; Blender, 3ds Max and Unreal have z.
enum class UpAxis {
    Y,
    Z,
};

/// All of them, in their order.
inline constexpr std::array kAllUpAxes{UpAxis::Y, UpAxis::Z};

/// "y" or "z".
[[nodiscard]] constexpr std::string_view nameOf(UpAxis up)
{
    return up == UpAxis::Y ? "y" : "z";
}

/// A place or a way in a file's axes, which stay right-handed.
[[nodiscard]] inline glm::vec3 turned(const glm::vec3& v, UpAxis up)
{
    return up == UpAxis::Z ? glm::vec3(v.x, -v.z, v.y) : v;
}

} // namespace fumage
