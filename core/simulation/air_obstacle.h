#pragma once

#include "core/flow/solid.h"
#include "core/simulation/simulation_model.h"

#include <optional>

namespace fumage {

/// What stands in the air; none: nothing.
[[nodiscard]] std::optional<Solid> obstacleOf(const Air& air);

/// What stands in the air at the end of a part of a step, and how it has come there: where a key frame takes it
/// elsewhere at once, it has not moved.
/// @param begin,end of the part, in steps of the model
/// @param seconds that it takes
/// @param before,now air at its beginning and at its end
[[nodiscard]] std::optional<Solid> obstacleIn(
    const SimulationModel& model, double begin, double end, float seconds, const Air& before, const Air& now);

} // namespace fumage
