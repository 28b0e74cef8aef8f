#include "core/export/sheet_grid.h"

#include <algorithm>

#include <glm/common.hpp>

namespace fumage {

glm::vec4 shown(const glm::vec4& colour)
{
    return glm::min(colour, glm::vec4(1.0F));
}

glm::vec4 shownBetween(const Image& sheet, const SheetCell& cell, float u, float v)
{
    const float x = std::clamp(u, 0.0F, static_cast<float>(cell.width - 1));
    const float y = std::clamp(v, 0.0F, static_cast<float>(cell.height - 1));
    const int left = static_cast<int>(x);
    const int top = static_cast<int>(y);
    const int right = std::min(left + 1, cell.width - 1);
    const int bottom = std::min(top + 1, cell.height - 1);
    const auto at = [&](int i, int j) { return shown(sheet.at(cell.left + i, cell.top + j)); };
    const float across = x - static_cast<float>(left);
    const float down = y - static_cast<float>(top);
    return glm::mix(glm::mix(at(left, top), at(right, top), across), glm::mix(at(left, bottom), at(right, bottom), across), down);
}

} // namespace fumage
