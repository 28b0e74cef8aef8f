#include "core/flow/field.h"

#include <cmath>
#include <cstring>

#include <glm/common.hpp>

namespace fumage {

namespace {

/// The value of a half float that is 0 or normal.
float fromHalf(std::uint16_t half)
{
    constexpr std::uint32_t kRebias = (127U - 15U) << 23U;
    const std::uint32_t magnitude = half & 0x7fffU;
    const std::uint32_t bits = magnitude == 0 ? 0 : (magnitude << 13U) + kRebias;
    const std::uint32_t sign = (half & 0x8000U) << 16U;
    const std::uint32_t all = sign | bits;
    float value = 0.0F;
    std::memcpy(&value, &all, sizeof(value));
    return value;
}

} // namespace

glm::vec4 AirField::at(const glm::vec3& place) const
{
    const glm::vec3 cellsAway = (place - grid.corner) / grid.cell;
    const glm::vec3 end(grid.cells);
    if (glm::any(glm::lessThan(cellsAway, glm::vec3(0.0F))) || glm::any(glm::greaterThan(cellsAway, end))) {
        return {wind, 0.0F};
    }
    const glm::vec3 low = glm::min(glm::floor(cellsAway), end - 1.0F);
    const glm::vec3 rest = cellsAway - low;
    glm::vec4 sum(0.0F);
    for (unsigned corner = 0; corner < 8; ++corner) {
        const glm::uvec3 high{corner & 1U, corner >> 1U & 1U, corner >> 2U};
        const glm::vec3 weights = glm::mix(1.0F - rest, rest, glm::vec3(high));
        const glm::uvec3 node = glm::uvec3(low) + high;
        const std::uint16_t* quad = quads.data() + 4 * node.x + row * node.y + plane * node.z;
        sum += weights.x * weights.y * weights.z
            * glm::vec4(fromHalf(quad[0]), fromHalf(quad[1]), fromHalf(quad[2]), fromHalf(quad[3]));
    }
    return sum;
}

} // namespace fumage
