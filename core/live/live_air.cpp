#include "core/live/live_air.h"

#include "core/simulation/air_plan.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace fumage {

namespace {

/// How far the emitter may be from its place in the box before that follows, in cells: beyond half a cell, so that one
/// that trembles does not move it to and fro.
constexpr float kSlack = 0.75F;

/// Farther than anything goes, in cells, and still an int.
constexpr float kFarthest = 1e9F;

/// The lowest that a box may go so that no more than a cell of it lies below the ground, in cells from where it is.
int cellsToGround(const AirGrid& grid, float height)
{
    constexpr float kRounding = 0.01F;
    return static_cast<int>(
        std::ceil(std::clamp((height - grid.corner.y) / grid.cell - kRounding, -kFarthest, kFarthest)));
}

/// A body that has gone a share of its way, and does not move on.
Solid onWay(const Solid& from, const Solid& to, float share)
{
    Solid out = to;
    if (share < 1.0F) {
        out.centre = glm::mix(from.centre, to.centre, share);
        out.size = glm::mix(from.size, to.size, share);
    }
    return out;
}

/// The layer whose emitter the box goes with.
std::size_t leaderOf(SampledLayers layers)
{
    std::vector<std::size_t> feeding;
    findFeedingLayers(layers, feeding);
    return feeding.front();
}

} // namespace

LiveAir::LiveAir(SampledLayers layers)
    : LiveAir(layers[leaderOf(layers)], airPlan(layers))
{
}

LiveAir::LiveAir(const SimulationModel& model)
    : LiveAir(SampledLayers(&model.effect(), 1))
{
}

LiveAir::LiveAir(const Effect& leader, const AirPlan& plan)
    : m_solver(plan.grid, plan.boundaries, plan.solids, plan.wind)
    , m_field(plan.grid)
    , m_solids(plan.solids)
    , m_borders(plan.boundaries)
    , m_home(plan.grid.corner)
    , m_emitter(leader.emitter.position)
{
    m_field.wind = plan.wind;
    if (!m_solids.empty()) {
        m_reached = m_target = m_solids.front();
    }
    const Air& air = leader.air;
    if (air.ground) {
        m_floor = cellsToGround(plan.grid, air.groundHeight);
    }
}

void LiveAir::follow(const glm::vec3& emitter)
{
    const float cell = grid().cell;
    const glm::vec3 away = glm::clamp((emitter - m_emitter) / cell, -kFarthest, kFarthest);
    glm::ivec3 gone = m_gone;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(away[axis] - static_cast<float>(gone[axis])) > kSlack) {
            gone[axis] = static_cast<int>(std::lround(away[axis]));
        }
    }
    AirBoundaries boundaries = m_borders;
    if (m_floor) {
        gone.y = std::max(gone.y, *m_floor);
        boundaries.low[1] = gone.y == *m_floor ? Boundary::Solid : Boundary::Open;
    }
    if (gone == m_gone) {
        return;
    }
    if (m_solver.move(gone - m_gone, m_home + cell * glm::vec3(gone), boundaries, m_solids, m_field.wind)) {
        m_gone = gone;
        m_borders = boundaries;
        m_field.grid = grid();
    }
}

void LiveAir::moveObstacle(float share)
{
    if (!m_step.obstacle || m_solids.empty()) {
        return;
    }
    m_target = *m_step.obstacle;
    const float farthest = std::max({m_target.size.x, m_target.size.y, m_target.size.z});
    const bool goes = glm::distance(m_reached.centre, m_target.centre) <= farthest;
    const Solid before = m_solids.front();
    const Solid after = goes ? onWay(m_reached, m_target, share) : m_target;
    Solid from = before;
    float passed = 0.0F;
    const auto move = [&](AirStep& part, bool isLast) {
        passed += part.share;
        const Solid to = isLast ? after : onWay(before, after, passed);
        part.obstacle = goes ? movedBetween(from, to, part.dt * static_cast<float>(part.pieces)) : to;
        from = to;
    };
    if (before.centre != after.centre || before.size != after.size) {
        for (AirStep& part : m_step.earlier) {
            move(part, false);
        }
        move(m_step, true);
    }
    m_solids.front() = *m_step.obstacle;
}

void LiveAir::step(std::span<const AirFeeder> feeders, std::int64_t number, double share)
{
    number = std::max<std::int64_t>(1, number);
    if (m_at == number) {
        return;
    }
    m_at = number;
    follow(feeders.front().model->effect()->emitter.position);
    findAirStep(feeders, grid(), m_step);
    // Since the effect before, too.
    AirStep& first = m_step.earlier.empty() ? m_step : m_step.earlier.front();
    first.windChange = (first.wind - m_field.wind) / static_cast<float>(first.pieces);
    moveObstacle(static_cast<float>(share));
    m_solver.step(m_step, m_field);
}

void LiveAir::step(const SimulationModel& model, std::int64_t number, float acts)
{
    const AirFeeder feeder{&model, std::max<std::int64_t>(1, number), acts};
    step({&feeder, 1}, number);
}

} // namespace fumage
