#include "core/flow/coordinate_map.h"

#include "core/base/parallel.h"
#include "core/flow/coordinate_map-inl.h"

// What the instruction set of the kernels needs, NEON's for instance, is asked for here too.
HWY_BEFORE_NAMESPACE();
namespace fumage {

void CoordinateMap::seed(const AirGrid& on)
{
    const NodeLayout layout(on.cells);
    grid = on;
    row = layout.row;
    plane = layout.plane;
    quads.assign(layout.size, 0.0F);
    parallelFor(static_cast<std::size_t>(on.cells.z) + 1, [&](std::size_t k) {
        for (int j = 0; j <= on.cells.y; ++j) {
            float* to = quads.data() + k * plane + static_cast<std::size_t>(j) * row;
            for (int i = 0; i <= on.cells.x; ++i, to += 4) {
                const glm::vec3 place = on.corner + on.cell * glm::vec3(i, j, static_cast<int>(k));
                to[0] = place.x;
                to[1] = place.y;
                to[2] = place.z;
                to[3] = 0.0F;
            }
        }
    });
}

AdvectedPlace advectedPlace(const CoordinateMap& map, const glm::vec3& place)
{
    namespace hn = hwy::HWY_NAMESPACE;
    const hn::CappedTag<float, 1> d;
    const auto lane = [](const auto& v) { return glm::vec3(hn::GetLane(v.x), hn::GetLane(v.y), hn::GetLane(v.z)); };
    const auto found = HWY_NAMESPACE::advectedPlaces(d, map, HWY_NAMESPACE::broadcast(d, place));
    return {lane(found.place), glm::mat3(lane(found.alongX), lane(found.alongY), lane(found.alongZ))};
}

} // namespace fumage
HWY_AFTER_NAMESPACE();
