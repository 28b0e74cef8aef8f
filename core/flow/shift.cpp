#include "core/flow/shift.h"

#include <algorithm>
#include <array>

namespace fumage {

void shiftPlane(
    const AirCells& cells, const AirColumn& from, const glm::ivec3& by, const glm::vec3& wind, AirColumn& to, int k)
{
    const glm::ivec3 n = cells.grid.cells;
    const std::array outside{wind.x, wind.y, wind.z, 0.0F};
    constexpr std::array kAtRest{0.0F, 0.0F, 0.0F, 0.0F};
    const auto isWithin = [](int i, int end) { return i >= 0 && i < end; };
    for (int j = 0; j < n.y; ++j) {
        const bool rowWasThere = isWithin(k + by.z, n.z) && isWithin(j + by.y, n.y);
        for (int i = 0; i < n.x; ++i) {
            const bool wasThere = rowWasThere && isWithin(i + by.x, n.x);
            const bool isSolid = cells.hasObstacles() && cells.fluid[cells.column.at(i, j, k)] == 0.0F;
            const float* const quad =
                wasThere ? from.data() + cells.quad.at(i + by.x, j + by.y, k + by.z) : outside.data();
            std::copy_n(isSolid ? kAtRest.data() : quad, 4, to.data() + cells.quad.at(i, j, k));
        }
    }
}

} // namespace fumage
