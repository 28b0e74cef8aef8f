#pragma once

#include "core/flow/step.h"
#include "core/simulation/simulation_model.h"

#include <span>

namespace fumage {

/// A layer that feeds the air, at a step by its own count.
struct AirFeeder {
    const SimulationModel* model = nullptr;
    std::int64_t number = 1;
    float acts = 0.0F; ///< share of the step in which its source gives anything off, from its beginning, 0 to 1
};

/// What moves the air of a scene from the step before to one. A step that is longer than air can be followed over, in
/// which a source would add too much of its own volume, or in which one stops, has parts, and these have pieces.
/// @param feeders one or more; the wind, and what stirs the air, are those of the first
/// @param grid that the air is on
[[nodiscard]] AirStep airStep(std::span<const AirFeeder> feeders, const AirGrid& grid);

/// The same into a step that was used before: allocates nothing where that had as many feeders and parts.
void findAirStep(std::span<const AirFeeder> feeders, const AirGrid& grid, AirStep& out);

/// The same of one emitter, from step number - 1 to step number.
/// @param acts as in AirFeeder
[[nodiscard]] AirStep airStep(const SimulationModel& model, const AirGrid& grid, std::int64_t number, float acts);

/// Parts of most steps of a scene: a burst that is over soon does not count.
[[nodiscard]] std::size_t usualParts(std::span<const AirFeeder> feeders);

/// Pieces that the air takes a time in.
/// @param acts whether the source gives anything off
[[nodiscard]] int piecesOfStep(const SampledEffect& effect, float seconds, bool acts);

/// The wind's speed: that at which drag balances its acceleration, as for a lone particle.
[[nodiscard]] glm::vec3 windSpeed(const glm::vec3& acceleration, const Air& air);

} // namespace fumage
