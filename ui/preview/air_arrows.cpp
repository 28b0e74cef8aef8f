#include "ui/preview/air_arrows.h"

#include <algorithm>
#include <cmath>

namespace fumage::ui {

std::vector<AirArrow> findAirArrows(const AirField& field, const glm::vec3& through, const glm::vec3& forward)
{
    constexpr int kLongSide = 40; // arrows
    const glm::vec3 size = field.grid.cell * glm::vec3(field.grid.cells);
    const int across = std::abs(forward.z) > std::abs(forward.x) ? 0 : 2;
    const float gap = std::max(size[across], size.y) / kLongSide;
    const auto count = [&](int axis) { return std::max(1, static_cast<int>(size[axis] / gap)); };
    std::vector<AirArrow> arrows;
    for (int j = 0; j < count(1); ++j) {
        for (int i = 0; i < count(across); ++i) {
            glm::vec3 place = through;
            place[across] = field.grid.corner[across]
                + (static_cast<float>(i) + 0.5F) * size[across] / static_cast<float>(count(across));
            place.y = field.grid.corner.y + (static_cast<float>(j) + 0.5F) * size.y / static_cast<float>(count(1));
            const glm::vec4 air = field.at(place);
            arrows.push_back({place, glm::vec3(air), air.w, gap});
        }
    }
    return arrows;
}

} // namespace fumage::ui
