#pragma once

#include "core/flow/field.h"
#include "core/flow/solver.h"
#include "core/simulation/model.h"

namespace fumage {

struct AirPlan;

/// The air of a simulation that steps with a game: computed one step after another, nothing of it kept.
/// Its box stays where it is at the start; the source goes with the emitter, and beyond the box is only the wind.
class LiveAir {
public:
    /// @param model of an effect with air, for which checkAir() has nothing to say
    explicit LiveAir(const Model& model);

    /// Moves it on to step number, one after the one before, of a model whose grid is grid().
    /// @param acts whether the source gives anything off
    /// Step 0 is as step 1: what carries newborns is the first air that has moved, as in AirRun.
    /// Allocates nothing after the first few steps.
    void step(const Model& model, std::int64_t number, bool acts);

    [[nodiscard]] const AirGrid& grid() const { return m_solver.grid(); }
    /// The air after the last step; stays where it is.
    [[nodiscard]] const AirField& field() const { return m_field; }

private:
    explicit LiveAir(const AirPlan& plan);

    AirSolver m_solver;
    AirField m_field;
    std::int64_t m_at = 0; ///< step that the air is at
};

} // namespace fumage
