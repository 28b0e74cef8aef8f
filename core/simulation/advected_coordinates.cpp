#include "core/simulation/advected_coordinates.h"

#include "core/base/math.h"
#include "core/flow/coordinate_step.h"

#include <algorithm>
#include <cmath>

namespace fumage {

namespace {

std::int64_t floorDivided(std::int64_t a, std::int64_t b)
{
    return a >= 0 ? a / b : -((-a + b - 1) / b);
}

/// Carries a map from its age to a later one, in steps of the air. Before step 0 of it the map is at rest.
Status carryOn(const SimulationModel& model, std::int64_t seededAt, std::int64_t age, AdvectedPhase& phase,
    CoordinateMap& room, const std::stop_token& stop)
{
    for (; phase.age < age; ++phase.age) {
        const std::int64_t step = seededAt + phase.age + 1;
        if (step <= 0) {
            continue;
        }
        const Result<AirFieldPtr> field = model.air()->field(step, stop);
        if (!field) {
            return field.error();
        }
        stepCoordinates(phase.map, *field.value(), model.schedule().dt, room);
    }
    return Done{};
}

} // namespace

SeedTimes::SeedTimes(const Schedule& schedule, float life)
    : m_loops(schedule.loopSteps > 0)
{
    constexpr double kMinSteps = 2.0; // one for each map
    const double steps = std::max(kMinSteps, static_cast<double>(life) / static_cast<double>(schedule.dt));
    if (m_loops) {
        m_steps = schedule.loopSteps;
        m_seeds = 2 * std::max<std::int64_t>(1, std::llround(static_cast<double>(m_steps) / steps));
    } else {
        m_steps = std::max<std::int64_t>(1, std::llround(0.5 * steps));
    }
}

std::int64_t SeedTimes::seedAt(std::int64_t step) const
{
    // The last s with floor(s steps / seeds) <= step.
    return floorDivided((step + 1) * m_seeds - 1, m_steps);
}

std::int64_t SeedTimes::stepOf(std::int64_t seed) const
{
    return floorDivided(seed * m_steps, m_seeds);
}

std::int64_t SeedTimes::randomNumber(std::int64_t seed) const
{
    return m_loops ? seed - floorDivided(seed, m_seeds) * m_seeds : seed;
}

bool AdvectedCoordinates::isFor(const SimulationModel& model, float life) const
{
    return m_model && m_model->air() == model.air() && m_life == life;
}

Status AdvectedCoordinates::moveTo(
    const std::shared_ptr<const SimulationModel>& model, std::int64_t step, float life, const std::stop_token& stop)
{
    const SeedTimes times(model->schedule(), life);
    if (!isFor(*model, life)) {
        m_phases[0].age = -1;
        m_phases[1].age = -1;
    }
    m_model = model;
    m_life = life;
    const std::int64_t now = model->airStep(step);
    const std::int64_t latest = times.seedAt(now);
    const auto sinceSeed = static_cast<float>(now - times.stepOf(latest));
    const float way = sinceSeed / static_cast<float>(times.stepOf(latest + 1) - times.stepOf(latest));
    for (const std::int64_t seed : {latest - 1, latest}) {
        AdvectedPhase& phase = m_phases[static_cast<std::size_t>(seed & 1)];
        const std::int64_t random = times.randomNumber(seed);
        const std::int64_t age = now - times.stepOf(seed);
        if (phase.age < 0 || phase.seed != random || phase.age > age) {
            phase.map.seed(model->air()->plan().grid);
            phase.seed = random;
            phase.age = 0;
        }
        if (Status status = carryOn(*model, times.stepOf(seed), age, phase, m_room, stop); !status) {
            phase.age = -1;
            return status;
        }
        phase.weight = seed == latest ? portableSin(0.5F * kPi * way) : portableCos(0.5F * kPi * way);
    }
    return Done{};
}

} // namespace fumage
