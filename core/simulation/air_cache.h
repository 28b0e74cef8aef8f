#pragma once

#include "core/effect/sampling.h"
#include "core/flow/air.h"
#include "core/simulation/air_plan.h"

#include <memory>
#include <mutex>
#include <vector>

namespace fumage {

/// Air that is baked, for all who simulate effects: those that differ only in what air knows nothing of, as look,
/// light, camera or the number of particles, share one bake. It is found as long as it is kept here or somebody uses
/// it. Thread-safe.
class AirCache {
public:
    /// @param most airs that are kept though nobody uses them; each has its own budget
    explicit AirCache(std::size_t most = 1)
        : m_most(most)
    {
    }

    /// The air of a scene, baked or to be baked; nullptr where none carries the smoke.
    /// @param layers for which checkAir() has nothing to say
    [[nodiscard]] std::shared_ptr<BakedAir> airOf(SampledLayers layers);
    /// The same of one layer.
    [[nodiscard]] std::shared_ptr<BakedAir> airOf(const SampledEffect& effect) { return airOf({&effect, 1}); }

    /// Forgets all airs; those that somebody uses live on until they are done.
    void clear();

    /// Whether the air of a scene is here and needs no more computing up to a frame.
    [[nodiscard]] bool isBaked(SampledLayers layers, int frame) const { return missingSteps(layers, frame) == 0; }
    /// How many steps of the air of a scene are still to be computed up to a frame, of a loop all of them; more than
    /// there are steps where none is here.
    [[nodiscard]] std::int64_t missingSteps(SampledLayers layers, int frame) const;

private:
    struct Shelved {
        std::vector<AirPart> parts; ///< airParts()
        std::weak_ptr<BakedAir> air;
        std::shared_ptr<BakedAir> kept; ///< null: too many others have been asked for since
    };

    std::size_t m_most;
    mutable std::mutex m_mutex;
    std::vector<Shelved> m_airs; ///< the one asked for last at the end
};

/// The air of a scene from a shelf.
/// @param shelf null: one that nobody else knows of
/// @see AirCache::airOf()
[[nodiscard]] std::shared_ptr<BakedAir> airFor(SampledLayers layers, const std::shared_ptr<AirCache>& shelf);

} // namespace fumage
