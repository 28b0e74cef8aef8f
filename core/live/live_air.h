#pragma once

#include "core/flow/field.h"
#include "core/flow/solver.h"
#include "core/simulation/air_step.h"

#include <optional>
#include <span>
#include <vector>

namespace fumage {

struct AirPlan;

/// The air of smoke that steps with a game: computed one step after another, nothing of it kept.
///
/// Its box goes with the emitter, of several layers with that of the first that feeds it (see findFeedingLayers()), by
/// whole cells: air that stays in it stays where it is in the world, what comes in is the wind, and what is left behind
/// is forgotten. So an emitter that moves less than a cell has the air of one that stands still, to the bit. Ground and
/// obstacle stay in the world, and where the obstacle is set elsewhere it moves there and pushes the air; the box never
/// goes under the ground, stands on it where it comes down to it, and leaves it with an emitter that rises. A wind that
/// is set moves all of the air at once, as gusts do.
class LiveAir {
public:
    /// @param layers with air, one or more, for which checkAir() has nothing to say
    explicit LiveAir(SampledLayers layers);
    /// The same of one.
    explicit LiveAir(const SimulationModel& model);

    /// Moves it on to step number, one after the one before.
    /// @param feeders one or more, whose air has the cells of grid(), in the order of findFeedingLayers()
    /// Step 0 is as step 1: what carries newborns is the first air that has moved, as in AirBake.
    /// Allocates nothing after the first few steps but where the box moves beside an obstacle, or on or off the ground.
    /// @param share of the way that the obstacle has gone by then from where it last arrived, 0 to 1. Farther than it
    /// is large it pushes nothing: it is there at once.
    void step(std::span<const AirFeeder> feeders, std::int64_t number, double share = 1.0);
    /// The same of one.
    /// @param acts share of the step in which the source gives anything off, 0 to 1
    void step(const SimulationModel& model, std::int64_t number, float acts);

    /// Lets the obstacle have come to where it goes.
    void arrive() { m_reached = m_target; }

    /// The box as it stands now.
    [[nodiscard]] const AirGrid& grid() const { return m_solver.grid(); }
    /// The air after the last step; stays where it is.
    [[nodiscard]] const AirField& field() const { return m_field; }

private:
    LiveAir(const Effect& leader, const AirPlan& plan);

    /// Finds how the obstacle comes from where it was to where it is at the end of the step.
    void moveObstacle(float share);
    /// Takes the box along where the emitter is no longer where it was in it.
    void follow(const glm::vec3& emitter);

    AirSolver m_solver;
    AirField m_field;
    AirStep m_step; ///< the last one, whose memory the next one has
    std::vector<Solid> m_solids; ///< as they are at the end of the last step
    Solid m_reached; ///< the obstacle, where there is one, where it last arrived
    Solid m_target; ///< where it goes
    AirBoundaries m_borders; ///< of the box as it stands now
    glm::vec3 m_home; ///< corner of the box at the start, m
    glm::vec3 m_emitter; ///< its place then, m
    glm::ivec3 m_gone{0}; ///< cells that the box has gone since
    std::optional<int> m_floor; ///< as m_gone.y, where the box stands on the ground; none: there is no ground
    std::int64_t m_at = 0; ///< step that the air is at
};

} // namespace fumage
