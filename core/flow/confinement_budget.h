#pragma once

#include <vector>

namespace fumage {

/// What a plane of cells has of motion and what confinement does to it: sums of squares and products of velocities
/// against the wind, (m/s)^2.
struct ConfinementWork {
    double motion = 0.0; ///< of what is carried, with all that acts on it before the confinement
    double along = 0.0; ///< of the confinement's velocity times that
    double own = 0.0; ///< of the confinement's velocity alone
};

/// How much of the confinement may act. It is there to give swirls back what the grid takes from them, and its strength
/// knows nothing of how much that was: where it is strong, still air would begin to boil, and go on for ever. So that
/// it makes no energy of nothing, it gives all of the air at most as much in a step as the air has lost while it was
/// carried, and again as much as heat and source have given it.
///
/// With s the share, v the velocity and f what confinement adds: 2 s sum(v.f) + s^2 sum(f.f) <= lost + given. Sums are
/// taken plane by plane, in one order.
class ConfinementBudget {
public:
    /// @param planes of the grid
    explicit ConfinementBudget(int planes)
        : m_planes(static_cast<std::size_t>(planes))
    {
    }

    struct Plane {
        double before = 0.0; ///< squares of the velocity, before the air has carried itself
        double carried = 0.0; ///< and after it, before the source
        ConfinementWork work;
    };

    [[nodiscard]] Plane& plane(int k) { return m_planes[static_cast<std::size_t>(k)]; }

    /// The largest share that is allowed, 0 to 1, of all planes.
    [[nodiscard]] float share() const;

private:
    std::vector<Plane> m_planes;
};

} // namespace fumage
