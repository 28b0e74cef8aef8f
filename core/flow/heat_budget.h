#pragma once

#include "core/flow/cells.h"

namespace fumage {

/// What heat there is before and after the air has carried itself, so that what MacCormack's method gains or loses can
/// be given back: it follows places and not volumes, and its limits take more from what is too little than from what is
/// too much, so that it does not keep sums by itself: a closed box would gain up to a quarter in 200 steps. For steps
/// without a source; beside one most of the gain is its own, and giving that back would take it from the plume above,
/// which keeps its flux as it is.
///
/// The difference is taken back where it arose: H + up max(0, G - H) + down min(0, G - H), with H the heat that has
/// been carried and G the first guess of the method, so that what is between the eight cells around stays between them.
/// The sums are taken plane by plane and in one order: the same for any number of threads. Source: Bermejo and Conde,
/// "A Conservative Quasi-Monotone Semi-Lagrangian Scheme", Monthly Weather Review 2002.
class HeatBudget {
public:
    /// Shares of what lies between the heat and its first guess, 0 to 1; at most one of them is not 0.
    struct Correction {
        float up = 0.0F;
        float down = 0.0F;
    };

    /// @param planes of the grid
    explicit HeatBudget(int planes)
        : m_planes(static_cast<std::size_t>(planes))
    {
    }

    /// Adds up plane k of the air, and what flows out of it through open boundaries in a time: upwind, with the
    /// velocity of the border's cells.
    void before(const AirCells& cells, float dt, int k);

    /// Adds up plane k of the heat that has been carried, and of what its first guess has more or less. Reads heat and
    /// guess.
    void after(const AirCells& cells, int k);

    /// What is to be done to the carried heat so that its sum is what it was, less what has left; as far as the first
    /// guess allows.
    [[nodiscard]] Correction correction() const;

    /// Corrects the heat of plane k. Reads guess.
    static void correct(AirCells& cells, const Correction& correction, int k);

private:
    struct Plane {
        double before = 0.0; ///< heat, cells
        double out = 0.0;
        double after = 0.0;
        double more = 0.0; ///< of the first guess
        double less = 0.0;
    };

    std::vector<Plane> m_planes;
};

} // namespace fumage
