#pragma once

#include "core/base/aligned_array.h"
#include "core/flow/grid.h"
#include "core/flow/solid.h"

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace fumage {

/// The air at one step, for all who read it: velocity and heat at the corners of the cells, rounded to half floats.
///
/// Between the nodes they are interpolated linearly along each axis. As much then flows into each cell as out of it
/// (see solver.h), on a wall of the box the velocity across it is 0, and nothing outside the box is needed.
struct AirField {
    AirField() = default;
    explicit AirField(const AirGrid& on)
        : grid(on)
    {
        const NodeLayout layout(on.cells);
        row = layout.row;
        plane = layout.plane;
        quads.resize(layout.size);
    }

    AirGrid grid;
    glm::vec3 wind{0.0F}; ///< velocity of the air outside the box, m/s
    std::size_t row = 0; ///< halves from a node to the one above
    std::size_t plane = 0;
    float share = 1.0F; ///< of a step, for which it carries
    std::optional<Solid> obstacle; ///< as AirStep has it
    std::vector<AirField> earlier; ///< what carries before it, where the step has parts
    AlignedArray<std::uint16_t> quads; ///< bits of (u, v, w, heat) of each node, x fastest; padded to whole vectors

    /// Memory that it takes with its earlier parts.
    [[nodiscard]] std::size_t bytes() const
    {
        std::size_t all = quads.size() * sizeof(std::uint16_t);
        for (const AirField& part : earlier) {
            all += part.bytes();
        }
        return all;
    }

    /// Velocity, m/s, and heat at a place; outside the box the wind. For looking at: slow.
    [[nodiscard]] glm::vec4 at(const glm::vec3& place) const;
};

} // namespace fumage
