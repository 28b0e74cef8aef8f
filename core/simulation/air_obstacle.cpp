#include "core/simulation/air_obstacle.h"

#include "core/effect/known_parameter.h"

namespace fumage {

std::optional<Solid> obstacleOf(const Air& air)
{
    if (air.obstacle == Obstacle::None) {
        return std::nullopt;
    }
    const SolidShape shape = air.obstacle == Obstacle::Sphere ? SolidShape::Sphere : SolidShape::Box;
    return Solid{shape, air.obstaclePosition, air.obstacleSize, {}, {}};
}

std::optional<Solid> obstacleIn(
    const SimulationModel& model, double begin, double end, float seconds, const Air& before, const Air& now)
{
    const std::optional<Solid> obstacle = obstacleOf(now);
    const bool isStill = before.obstaclePosition == now.obstaclePosition && before.obstacleSize == now.obstacleSize;
    if (!obstacle || isStill || model.jumpsBetween(knownParameter("air.obstacle_position"), begin, end)
        || model.jumpsBetween(knownParameter("air.obstacle_size"), begin, end)) {
        return obstacle;
    }
    return movedBetween(*obstacleOf(before), *obstacle, seconds);
}

} // namespace fumage
