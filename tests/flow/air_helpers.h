#pragma once

#include "tests/flow/flow_helpers.h"

#include "core/flow/air.h"

namespace fumage::tests {

/// A ragged plume in a small box.
inline AirPlan smallPlan(std::int64_t loopSteps = 0, const glm::ivec3& cells = {17, 24, 16})
{
    AirPlan plan;
    plan.grid = boxOf(cells, 2.0F);
    plan.boundaries = onGround();
    plan.firstStep = loopSteps;
    plan.loopSteps = loopSteps;
    plan.stepTo = [grid = plan.grid, loopSteps](std::int64_t number) {
        AirStep step = plumeStep(grid, 0.3F);
        const std::int64_t seen = loopSteps == 0 ? number : number % loopSteps;
        makeRagged(step, 0.3F, static_cast<float>(seen) * step.dt);
        step.confinement = 0.1F;
        step.vortex = {0.5F, 0.3F, 0.1F, {0.1F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, 0.05F};
        return step;
    };
    return plan;
}

inline AlignedArray<std::uint16_t> bitsAt(BakedAir& air, std::int64_t step)
{
    return air.field(step).value()->quads;
}

} // namespace fumage::tests
