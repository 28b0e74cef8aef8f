#include "core/flow/confinement_budget.h"

#include <algorithm>
#include <cmath>

namespace fumage {

float ConfinementBudget::share() const
{
    double lost = 0.0;
    double given = 0.0;
    ConfinementWork all;
    for (const Plane& plane : m_planes) {
        lost += plane.before - plane.carried;
        given += plane.work.motion - plane.carried;
        all.along += plane.work.along;
        all.own += plane.work.own;
    }
    const double allowed = std::max(0.0, lost) + std::max(0.0, given);
    if (2.0 * all.along + all.own <= allowed) {
        return 1.0F;
    }
    // The root of own s^2 + 2 along s - allowed, without the cancellation of its usual form.
    const double root = std::sqrt(all.along * all.along + all.own * allowed);
    const double share = all.along > 0.0 ? allowed / (root + all.along) : (root - all.along) / all.own;
    return static_cast<float>(std::clamp(share, 0.0, 1.0));
}

} // namespace fumage
