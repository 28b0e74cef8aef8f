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
    std::erase_if(m_airs, [](const Shelved& each) { return each.air.expired(); });
    const auto found =
        std::find_if(m_airs.begin(), m_airs.end(), [&](const Shelved& each) { return each.parts == parts; });
    std::shared_ptr<BakedAir> air = found != m_airs.end() ? found->air.lock() : nullptr;
    if (found != m_airs.end()) {
        m_airs.erase(found);
    }
    if (!air) {
        air = std::make_shared<BakedAir>(airPlan(layers));
    }
    m_airs.push_back({std::move(parts), air, m_most > 0 ? air : nullptr});
    if (m_airs.size() > m_most) {
        m_airs[m_airs.size() - 1 - m_most].kept = nullptr;
    }
    return air;
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
        std::find_if(m_airs.begin(), m_airs.end(), [&](const Shelved& each) { return each.parts == parts; });
    const std::shared_ptr<BakedAir> air = found != m_airs.end() ? found->air.lock() : nullptr;
    if (air) {
        return air->missingSteps(step);
    }
    return firstAirStep(layers) + 2 * schedule.loopSteps + step + 1;
}

std::shared_ptr<BakedAir> airFor(SampledLayers layers, const std::shared_ptr<AirCache>& shelf)
{
    return shelf ? shelf->airOf(layers) : AirCache().airOf(layers);
}

} // namespace fumage
