#include "core/simulation/air_cache.h"

#include "core/simulation/air_plan.h"
#include "core/simulation/simulation_model.h"

#include <algorithm>

namespace fumage {

std::shared_ptr<BakedAir> AirCache::airOf(const SampledEffect& effect)
{
    if (!effect->air.enabled) {
        return nullptr;
    }
    const Effect part = airPart(effect);
    const std::scoped_lock lock(m_mutex);
    const auto found = std::find_if(m_airs.begin(), m_airs.end(), [&](const auto& each) { return each.first == part; });
    if (found != m_airs.end()) {
        std::rotate(found, found + 1, m_airs.end());
        return m_airs.back().second;
    }
    while (!m_airs.empty() && m_airs.size() >= m_most) {
        m_airs.erase(m_airs.begin());
    }
    return m_airs.emplace_back(part, std::make_shared<BakedAir>(airPlan(SimulationModel(effect)))).second;
}

void AirCache::clear()
{
    const std::scoped_lock lock(m_mutex);
    m_airs.clear();
}

std::int64_t AirCache::missingSteps(const SampledEffect& effect, std::int64_t step) const
{
    const Effect part = airPart(effect);
    const std::scoped_lock lock(m_mutex);
    const auto found = std::find_if(m_airs.begin(), m_airs.end(), [&](const auto& each) { return each.first == part; });
    if (found != m_airs.end()) {
        return found->second->missingSteps(step);
    }
    const Schedule schedule = makeSchedule(effect);
    return schedule.firstStep + 2 * schedule.loopSteps + step + 1;
}

} // namespace fumage
