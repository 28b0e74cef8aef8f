#pragma once

#include "core/flow/step.h"
#include "core/simulation/simulation_model.h"

namespace fumage {

/// What moves the air of an effect from step number - 1 to step number. A step that is longer than air can be followed
/// over, in which the source would add too much of its own volume, or in which it stops, has parts, and these have
/// pieces.
/// @param grid that the air is on
/// @param acts share of the step in which the source gives anything off, from its beginning, 0 to 1
[[nodiscard]] AirStep airStep(const SimulationModel& model, const AirGrid& grid, std::int64_t number, float acts);

/// Parts of most steps of an effect: a burst that is over soon does not count.
[[nodiscard]] std::size_t usualParts(const SimulationModel& model);

/// Pieces that the air takes a time in.
/// @param acts whether the source gives anything off
[[nodiscard]] int piecesOfStep(const SampledEffect& effect, float seconds, bool acts);

/// The wind's speed: that at which drag balances its acceleration, as for a lone particle.
[[nodiscard]] glm::vec3 windSpeed(const glm::vec3& acceleration, const Air& air);

} // namespace fumage
