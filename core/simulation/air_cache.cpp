#include "core/simulation/air_cache.h"

#include "core/simulation/air_plan.h"
#include "core/simulation/simulation_model.h"

#include <algorithm>

namespace fumage {

std::shared_ptr<BakedAir> AirCache::airOf(SampledLayers layers)
{
    if (!layers.front()->air.enabled) {
        return nullptr;
    }
    std::vector<AirPart> parts = airParts(layers);
    const std::scoped_lock lock(m_mutex);
    const auto found =
        std::find_if(m_airs.begin(), m_airs.end(), [&](const auto& each) { return each.first == parts; });
    if (found != m_airs.end()) {
        std::rotate(found, found + 1, m_airs.end());
        return m_airs.back().second;
    }
    while (!m_airs.empty() && m_airs.size() >= m_most) {
        m_airs.erase(m_airs.begin());
    }
    return m_airs.emplace_back(std::move(parts), std::make_shared<BakedAir>(airPlan(layers))).second;
}

void AirCache::clear()
{
    const std::scoped_lock lock(m_mutex);
    m_airs.clear();
}

std::int64_t AirCache::missingSteps(SampledLayers layers, int frame) const
{
    const std::vector<AirPart> parts = airParts(layers);
    const Schedule schedule = makeSchedule(layers.front());
    const std::int64_t step = firstAirStep(layers) + frame * schedule.stepsPerFrame;
    const std::scoped_lock lock(m_mutex);
    const auto found =
        std::find_if(m_airs.begin(), m_airs.end(), [&](const auto& each) { return each.first == parts; });
    if (found != m_airs.end()) {
        return found->second->missingSteps(step);
    }
    return firstAirStep(layers) + 2 * schedule.loopSteps + step + 1;
}

} // namespace fumage
