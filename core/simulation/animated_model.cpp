// What of a model changes over time.

#include "core/simulation/simulation_model.h"

#include "core/base/vector.h"
#include "core/effect/known_parameter.h"
#include "core/effect/track_jumps.h"

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
    sum(knownParameter("turbulence.drift"), m_schedule, m_drift);
    sum(knownParameter("turbulence.evolution"), m_schedule, m_evolution);
}

void SimulationModel::continueFrom(const SimulationModel& before, std::int64_t step)
{
    const Turbulence& was = before.m_effect->turbulence;
    const Turbulence& is = m_effect->turbulence;
    const double seconds = static_cast<double>(step) * static_cast<double>(m_schedule.dt);
    const auto beyond = [&](float earlier, float now) {
        return (static_cast<double>(earlier) - static_cast<double>(now)) * seconds;
    };
    m_pace = before.m_pace;
    m_pace.drifted += beyond(was.drift, is.drift);
    m_pace.evolved += beyond(was.evolution, is.evolution);
}

bool SimulationModel::evolves() const
{
    const Turbulence& turbulence = m_effect->turbulence;
    const bool drifts = turbulence.drift != 0.0F || m_drift;
    return turbulence.evolution > 0.0F || m_evolution || m_pace.evolved != 0.0 || (m_schedule.loopSteps != 0 && drifts);
}

RowPosition SimulationModel::evolvedTo(std::int64_t step, double cellsPerStep, double faster) const
{
    const auto now = static_cast<double>(step);
    if (m_evolution) {
        return m_evolution->row(now, m_schedule, faster);
    }
    if (m_pace.evolved == 0.0 && m_pace.evolution == m_effect->turbulence.evolution) {
        return rowPosition(now, m_schedule, cellsPerStep);
    }
    const double rate = static_cast<double>(m_effect->turbulence.evolution) * static_cast<double>(m_schedule.dt);
    return rowPosition(1.0, m_schedule, std::max(0.0, m_pace.evolved + rate * now) * faster);
}

SimulationModel::Drift SimulationModel::driftedTo(float drift, std::int64_t step, double latticePerMetre) const
{
    const auto dt = static_cast<double>(m_schedule.dt);
    const auto now = static_cast<double>(m_schedule.randomStep(step));
    const auto loop = static_cast<double>(m_schedule.loopSteps);
    Drift out;
    out.perStep = static_cast<double>(drift) * latticePerMetre * dt;
    // In a loop the smoke drifts by whole units of the lattice, or the slice that lives through its end would jump.
    // Whole numbers are multiplied before they are divided, so that a quotient is exact where it is whole.
    const double all = m_drift ? m_drift->all() * latticePerMetre : out.perStep * loop;
    out.inLoop = std::round(all);
    if (m_drift) {
        out.now = m_drift->at(now) * latticePerMetre + (loop > 0.0 ? (out.inLoop - all) * now / loop : 0.0);
    } else if (m_pace.drifted != 0.0 || m_pace.drift != m_effect->turbulence.drift) {
        out.now = (m_pace.drifted + static_cast<double>(m_effect->turbulence.drift) * now * dt) * latticePerMetre;
    } else {
        out.now = loop > 0.0 ? out.inLoop * now / loop : out.perStep * now;
    }
    return out;
}

const SampledEffect& SimulationModel::effectAt(double step, std::optional<SampledEffect>& room) const
{
    return m_changes ? room.emplace(m_effect.atTime(secondsOfStep(m_schedule, m_effect->timeline, step))) : m_effect;
}

bool SimulationModel::jumpsBetween(const Parameter& row, double from, double to) const
{
    const Track* track = m_effect.track(row);
    if (track == nullptr) {
        return false;
    }
    const double before = std::max(0.0, secondsOfStep(m_schedule, m_effect->timeline, from));
    const double now = std::max(0.0, secondsOfStep(m_schedule, m_effect->timeline, to));
    return jumpsOnWay(*track, before, now, lengthInSeconds(m_effect->timeline));
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
        return track != nullptr && jumpsOnWay(*track, before, now, lengthInSeconds(m_effect->timeline));
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
