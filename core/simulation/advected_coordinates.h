#pragma once

#include "core/base/result.h"
#include "core/flow/coordinate_map.h"
#include "core/simulation/simulation_model.h"

#include <array>
#include <cstdint>
#include <memory>
#include <stop_token>

namespace fumage {

/// When the coordinates of advected noise are seeded anew, in whole steps: two maps take turns, so that each is seeded
/// while it is not seen. In a loop there is a whole number of turns, all nearly as long as asked for.
class SeedTimes {
public:
    /// @param life s from a seed to the next of the same map
    SeedTimes(const Schedule& schedule, float life);

    /// The last seed at or before a step; even ones are those of the first map.
    [[nodiscard]] std::int64_t seedAt(std::int64_t step) const;
    [[nodiscard]] std::int64_t stepOf(std::int64_t seed) const;
    /// The number that randomness sees: the same in every turn of a loop.
    [[nodiscard]] std::int64_t randomNumber(std::int64_t seed) const;

private:
    std::int64_t m_seeds = 1; ///< in a period
    std::int64_t m_steps = 1; ///< of a period
    bool m_loops = false;
};

/// One of the two maps at a step.
struct AdvectedPhase {
    CoordinateMap map;
    std::int64_t seed = 0; ///< the number that randomness sees
    std::int64_t age = -1; ///< steps since then; below 0: not yet seeded
    float weight = 0.0F; ///< sine of its age over its life, half a turn: squares of both weights sum to 1
};

/// Coordinates for noise that the air carries: two maps that are seeded in turns, since air in time deforms each beyond
/// use (Max and Becker 1995; Neyret, "Advected Textures", SCA 2003).
///
/// A pure function of the air, the step and the life of a map, and so the same for all layers in one air: steps on from
/// where it is if that is nearer, else from the seeds, at most a life and a half of steps of maps. Not thread-safe;
/// uses all threads inside.
class AdvectedCoordinates {
public:
    /// @param model with baked air
    /// @param step of the particles of the model
    /// @param life s from a seed of a map to its next
    /// @error Cancelled; that of the air
    [[nodiscard]] Status moveTo(const std::shared_ptr<const SimulationModel>& model, std::int64_t step, float life,
        const std::stop_token& stop);

    /// Whether they were moved last in the air of a model, with this life: those of one moment serve all such layers.
    [[nodiscard]] bool isFor(const SimulationModel& model, float life) const;

    [[nodiscard]] const std::array<AdvectedPhase, 2>& phases() const { return m_phases; }

private:
    std::shared_ptr<const SimulationModel> m_model; ///< whose air the maps have followed
    float m_life = 0.0F;
    std::array<AdvectedPhase, 2> m_phases;
    CoordinateMap m_room;
};

} // namespace fumage
