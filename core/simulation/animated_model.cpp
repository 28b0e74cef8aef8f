// What of a model changes over time.

#include "core/simulation/simulation_model.h"

#include "core/base/vector.h"
#include "core/effect/known_parameter.h"

#include <algorithm>
#include <cmath>

namespace fumage {

void SimulationModel::sumRates()
{
    const auto sum = [&](const Parameter& row, const Schedule& schedule, std::optional<RateSum>& out) {
        if (const Track* track = m_effect.track(row)) {
            out.emplace(*track, schedule, m_effect->timeline);
        }
    };
    if (m_changes) {
        m_strongest = m_effect.strongest();
    }
    Schedule ofTheWind = m_schedule;
    ofTheWind.firstStep += m_clock.stepsBehind;
    sum(knownParameter("wind.gust_rate"), ofTheWind, m_gusts);
    sum(knownParameter("source.surge_rate"), m_schedule, m_surges);
    sum(knownParameter("rings.speed"), m_schedule, m_rings);
}

const SampledEffect& SimulationModel::effectAt(double step, std::optional<SampledEffect>& room) const
{
    return m_changes ? room.emplace(m_effect.atTime(secondsOfStep(m_schedule, m_effect->timeline, step))) : m_effect;
}

Spawner SimulationModel::spawnerAt(std::int64_t step) const
{
    if (!m_effect.isAnimated(Animates::Birth)) {
        return Spawner(m_effect->emitter);
    }
    const auto secondsAt = [&](std::int64_t at) {
        return secondsOfStep(m_schedule, m_effect->timeline, static_cast<double>(at));
    };
    const double now = secondsAt(step);
    const double before = secondsAt(step - 1);
    Emitter at = m_effect.atTime(now)->emitter;
    if (m_parent) {
        at.position = m_effect->emitter.position; // it is taken to where the parent's particles are
        return Spawner(at);
    }
    const Emitter from = m_effect.atTime(before)->emitter;
    const auto jumps = [&](const Parameter& row) {
        const Track* track = m_effect.track(row);
        // At the end of a loop it is where it was at the beginning, or it jumps there.
        return track != nullptr && (now < before || track->jumpsIn(before, now));
    };
    EmitterTravel coming;
    coming.betweenSteps = m_schedule.betweenSteps;
    coming.normalBefore = at.normal;
    if (!jumps(knownParameter("emitter.position"))) {
        coming.way = at.position - from.position;
        coming.velocity = at.inherit / m_schedule.dt * coming.way;
    }
    if (!jumps(knownParameter("emitter.normal")) && !areAlmostOpposite(at.normal, from.normal)) {
        coming.normalBefore = from.normal;
    }
    return Spawner(at, coming);
}

RowPosition SimulationModel::surgeAt(double step) const
{
    return m_surges ? m_surges->row(step, m_schedule)
                    : rowPosition(step, m_schedule,
                        static_cast<double>(m_effect->source.surgeRate) * static_cast<double>(m_schedule.dt));
}

double SimulationModel::ringsPassed(std::int64_t step, StepConstants& out) const
{
    const Rings& rings = m_effect->rings;
    const auto spacing = static_cast<double>(rings.spacing);
    const auto now = static_cast<double>(m_schedule.randomStep(step));
    const auto loop = static_cast<double>(m_schedule.loopSteps);
    double passed = static_cast<double>(rings.speed) * static_cast<double>(m_schedule.dt) / spacing; // rings a step
    if (m_schedule.loopSteps == 0) {
        return m_rings ? m_rings->at(now) / spacing : passed * now;
    }
    const double all = m_rings ? m_rings->at(loop) / spacing : passed * loop;
    const double inLoop = std::round(all);
    out.ringsInLoop = static_cast<float>(std::max(1.0, inLoop));
    if (m_rings) {
        return all > 0.0 ? m_rings->at(now) / spacing * inLoop / all : 0.0;
    }
    passed = inLoop / loop;
    return passed * now;
}

} // namespace fumage
