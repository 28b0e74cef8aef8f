#include "core/live/live_air.h"

#include "core/simulation/air_plan.h"

#include <algorithm>

namespace fumage {

LiveAir::LiveAir(const Model& model)
    : LiveAir(airPlan(model))
{
}

LiveAir::LiveAir(const AirPlan& plan)
    : m_solver(plan.grid, plan.borders, plan.solids, plan.wind)
    , m_field(plan.grid)
{
}

void LiveAir::step(const Model& model, std::int64_t number, bool acts)
{
    number = std::max<std::int64_t>(1, number);
    if (m_at == number) {
        return;
    }
    m_at = number;
    const AirStep step = airStep(model, grid(), number, acts);
    m_solver.step(step);
    m_solver.read(m_field);
    m_field.wind = step.wind;
}

} // namespace fumage
