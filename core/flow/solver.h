#pragma once

#include "core/base/parallel.h"
#include "core/flow/cells.h"
#include "core/flow/field.h"
#include "core/flow/heat_budget.h"
#include "core/flow/multigrid.h"
#include "core/flow/obstacles.h"
#include "core/flow/step.h"
#include "core/flow/confinement_budget.h"

#include <functional>
#include <memory>

#include <glm/vec4.hpp>

namespace fumage {

/// The air: incompressible, lifted by its heat, on a grid of cubic cells.
///
///     du/dt + (u.grad) u = -grad p + B T up + epsilon h (N x w) + sources,   div u = expansion of the source
///     dT/dt + u.grad T   = -cooling T + sources
///
/// Velocity and heat stand together in the middle of the cells, and the pressure makes the velocities *through the
/// faces* free of divergence: they are the means of two cells, less the difference of their pressures. Why: with all
/// four numbers in one place a step traces each cell back once and fetches a corner of the grid at once, where a
/// staggered grid traces and fetches three times over; and with the pressure solved on the faces its stencil has no
/// chess board in it, which plain cell-centred grids have. What differs between the two velocities of a cell is of
/// second order and goes with the advection of the next step.
///
/// What others read are the velocities of the faces, smoothed onto the corners of cells (half from the face and a
/// quarter from its two neighbours along its own axis, the mean of four across it). That smoothing is the same for all
/// three, so as much flows out of each cell as in, and particles that it carries are neither gathered nor driven apart:
/// their counts stay those of chance.
///
/// Where no source acts, heat is neither gained nor lost on its way, see HeatBudget. Confinement gives no more than was
/// lost, see ConfinementBudget.
///
/// A step allocates nothing; it is the same to the bit for any number of threads, and on every instruction set.
/// Sources: Stam 1999; Selle et al. 2008 (advection); Almgren, Bell, Szymczak 1996 (projection); Fedkiw et al. 2001
/// (forces).
///
/// A wall that moves has its own velocity on the faces that it closes, so that it pushes the air before it and draws it
/// along behind; friction acts on what the air has against it. Cells that it leaves have the velocity that it gave
/// them. Source: Bridson, "Fluid Simulation for Computer Graphics", 2015, of solids that are voxels.
class AirSolver {
public:
    /// The air at rest, or moving with a wind.
    /// @param solids obstacles; at least one cell has to be left
    AirSolver(const AirGrid& grid, const AirBoundaries& boundaries, std::span<const Solid> solids = {},
        const glm::vec3& wind = glm::vec3(0.0F));

    /// Moves the air on by a step, part after part.
    void step(const AirStep& step);

    /// The same, and reads the air after each part.
    /// @param field made for the grid; gets the air of its earlier parts too
    void step(const AirStep& step, AirField& field);

    /// Moves the box on by whole cells. Air that stays in it stays where it is in the world, what comes in is cold and
    /// moves with the wind. Allocates only where boundaries change, or obstacles lie in the box before or after.
    /// @param by      cells
    /// @param corner  where the box begins afterwards, m: as far away as the cells say
    /// @param boundaries of the box where it is then, as closed as they were
    /// @param solids  all obstacles, in the world
    /// @return false: an obstacle would fill the box, and nothing has changed
    [[nodiscard]] bool move(const glm::ivec3& by, const glm::vec3& corner, const AirBoundaries& boundaries,
        std::span<const Solid> solids, const glm::vec3& wind);

    /// Puts velocity (x, y, z) and heat (w) at the centre of every cell, made free of divergence.
    /// @param wind of the air outside, m/s
    void set(const std::function<glm::vec4(const glm::vec3& place)>& airAt, const glm::vec3& wind = glm::vec3(0.0F));

    /// The state after the last step or set(), for those who read it; what there is of earlier parts stays as it is.
    /// @param field made for the grid
    void read(AirField& field) const;

    /// The state as a step takes it up again.
    [[nodiscard]] AirState state() const { return {m_cells.air, m_cells.carrier, m_solids}; }
    void restore(const AirState& state);

    [[nodiscard]] const AirGrid& grid() const { return m_cells.grid; }
    /// Whether a cell is part of an obstacle.
    [[nodiscard]] bool isSolid(const glm::ivec3& cell) const;
    /// Velocity and heat of a cell.
    [[nodiscard]] glm::vec4 at(const glm::ivec3& cell) const;
    /// What flows out of a cell through its faces beyond what its source adds, 1/s: what the pressure has left.
    [[nodiscard]] float divergenceAt(const glm::ivec3& cell) const;

    /// V cycles of the pressure in a step.
    static constexpr int kCycles = 2;

private:
    /// Moves the air on by a piece of a step.
    void stepPiece(const AirStep& step);
    /// Puts solids where they are now.
    /// @return false: no air would be left, and nothing has changed
    bool place(std::span<const Solid> solids);
    /// Puts the obstacle of a step where it is at its end, if it is not there: the air moves around it from then on.
    void moveObstacle(const AirStep& step);
    /// Takes back what the confinement has given beyond its budget.
    void limitConfinement(const AirStep& step);
    /// Everything after the forces: reads and changes forced.
    void project(const glm::vec3& wind);
    /// Takes from every cell of a closed box the mean of what flows out of them: nothing can leave it.
    void balance();

    /// The curl around the plane that a thread is at: kept no longer, so that it stays near the processor.
    struct CurlPlanes {
        std::array<CurlPlane, 3> planes; ///< plane k is the one of index k % 3

        /// Finds what is missing for plane k.
        /// @param isFirst false: plane k - 1 was the last one that was asked for
        [[nodiscard]] CurlAround around(const AirCells& cells, int k, bool isFirst);
    };

    AirCells m_cells;
    std::vector<Solid> m_solids;
    PerThread<CurlPlanes> m_curl;
    Multigrid m_multigrid;
    HeatBudget m_heat;
    ConfinementBudget m_confinement;
};

} // namespace fumage
