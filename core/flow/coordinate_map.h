#pragma once

#include "core/base/aligned_array.h"
#include "core/flow/grid.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace fumage {

/// Coordinates that ride on the air: of each node of its grid, where the air that is there now was when the map was
/// seeded. Between the nodes they are interpolated linearly; outside the box they go on as the places do.
struct CoordinateMap {
    AirGrid grid;
    std::size_t row = 0; ///< floats from a node to the one above, as in an AirField halves
    std::size_t plane = 0;
    AlignedArray<float> quads; ///< (x, y, z, 0) of each node, m; x fastest, padded as an AirField is

    /// Makes every node its own coordinate.
    void seed(const AirGrid& on);
};

/// Where the air of a place came from, and how that changes with the place: the inverse of its deformation since.
struct AdvectedPlace {
    glm::vec3 place{0.0F}; ///< m
    glm::mat3 slope{1.0F}; ///< column i: its change along axis i, m for each m
};

/// One place; many at a time: coordinate_map-inl.h.
/// @param place m
[[nodiscard]] AdvectedPlace advectedPlace(const CoordinateMap& map, const glm::vec3& place);

} // namespace fumage
