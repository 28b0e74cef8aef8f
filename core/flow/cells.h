#pragma once

#include "core/base/aligned_array.h"
#include "core/flow/grid.h"
#include "core/flow/solid.h"

#include <vector>

namespace fumage {

using AirColumn = AlignedArray<float>;

/// Three numbers a cell, or one on each of its three lower faces.
struct AirVectors {
    AirColumn x, y, z;

    void resize(std::size_t size)
    {
        x.assign(size, 0.0F);
        y.assign(size, 0.0F);
        z.assign(size, 0.0F);
    }
    /// Keeps its room.
    void clear()
    {
        x.clear();
        y.clear();
        z.clear();
    }
};

/// The curl of the velocity in a plane of cells, with a ring of ghosts.
struct CurlPlane {
    AirVectors curl; ///< m/s a cell
    AirColumn vorticity; ///< its length

    /// Makes room, if there is none.
    void makeRoom(const ColumnLayout& layout)
    {
        const std::size_t size = layout.plane + 2 * kAirLanes;
        if (vorticity.size() != size) {
            curl.resize(size);
            vorticity.assign(size, 0.0F);
        }
    }

    /// Cell (0, j).
    static std::size_t at(const ColumnLayout& layout, int j)
    {
        return kAirLanes + static_cast<std::size_t>(j + 1) * layout.row;
    }
};

/// The curl of three planes, k - 1 to k + 1; beyond the first and the last plane of the box, that of those.
using CurlAround = std::array<const CurlPlane*, 3>;

/// What lives from one step to the next: quads of all cells, with their ghosts, and what stands in them.
struct AirState {
    AirColumn air; ///< velocity in the middle of each cell, and heat
    AirColumn carrier; ///< means of the velocities through the faces of each cell, which carry the air in the next
                       ///< step; fourth number unused
    std::vector<Solid> solids;

    [[nodiscard]] std::size_t bytes() const { return (air.size() + carrier.size()) * sizeof(float); }
};

/// All that a step reads and writes. Only air and carrier live from one step to the next; all else is room to work in,
/// made once.
struct AirCells {
    AirCells(const AirGrid& on, const AirBoundaries& within)
        : grid(on)
        , boundaries(within)
        , column(on.cells)
        , quad(on.cells)
    {
        air.assign(quad.size, 0.0F);
        carrier.assign(quad.size, 0.0F);
        guess.assign(quad.size, 0.0F);
        for (AirVectors* vectors : {&velocity, &forced}) {
            vectors->resize(column.size);
        }
        for (AirColumn* numbers : {&heat, &divergence, &pressure}) {
            numbers->assign(column.size, 0.0F);
        }
    }

    AirGrid grid;
    AirBoundaries boundaries;
    ColumnLayout column;
    QuadLayout quad;

    AirColumn air; ///< quads, see AirState
    AirColumn carrier; ///< quads, see AirState
    AirColumn guess; ///< quads: the state carried, first guess of MacCormack's method
    AirVectors velocity; ///< carried, m/s
    AirVectors
        forced; ///< carried and accelerated, m/s; while the air is carried, the cells that it comes along in the step
    AirColumn heat;
    AirColumn divergence; ///< m/s a cell, less the expansion of the source
    AirColumn pressure; ///< times dt / density / cell: velocity loses its difference

    // Empty where there is no obstacle.
    AirVectors open; ///< whether a lower face lets air through: 1 or 0
    AirColumn fluid; ///< whether a cell is air: 1 or 0
    AirColumn touching; ///< how many faces of a cell of air are walls of obstacles
    CellBox around; ///< all cells that obstacles may lie in, and those beside them
    CellBox changed; ///< what was around obstacles before they were last placed, and what is since
    struct Halo { ///< a cell of an obstacle that has air beside it
        glm::ivec3 cell{0};
        unsigned sides = 0; ///< bit 2 * axis for the neighbour below, bit 2 * axis + 1 for the one above
    };
    std::vector<Halo> skin;
    [[nodiscard]] bool hasObstacles() const { return !fluid.empty(); }

    // Empty where there is no obstacle that moves.
    AirVectors wall; ///< velocity of the obstacle on each lower face that it closes, along the face's axis, m/s; else 0
    glm::vec3 wallVelocity{0.0F}; ///< of its centre, m/s
    [[nodiscard]] bool hasMovingWalls() const { return !wall.x.empty(); }
    /// Whether a face of plane k, or of one beside it, may be a wall that moves.
    [[nodiscard]] bool hasMovingWallsBeside(int k) const
    {
        return hasMovingWalls() && k >= around.low.z - 2 && k < around.high.z + 2;
    }

    AirColumn fluidAnew; ///< room to place obstacles in
};

} // namespace fumage
