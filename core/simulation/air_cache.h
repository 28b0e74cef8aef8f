#pragma once

#include "core/effect/sampling.h"
#include "core/flow/air.h"

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace fumage {

/// Air that is baked, for all who simulate effects: those that differ only in what air knows nothing of, as look,
/// light, camera or the number of particles, share one bake. Thread-safe.
class AirCache {
public:
    /// @param most airs that are kept; each has its own budget
    explicit AirCache(std::size_t most = 1)
        : m_most(most)
    {
    }

    /// The air of an effect, baked or to be baked; nullptr where none carries the smoke.
    /// @param effect for which checkAir() has nothing to say
    [[nodiscard]] std::shared_ptr<BakedAir> airOf(const SampledEffect& effect);

    /// Lets go of all airs; those that somebody uses live on until they are done.
    void clear();

    /// Whether the air of an effect is here and needs no more computing up to a step.
    [[nodiscard]] bool isBaked(const SampledEffect& effect, std::int64_t step) const
    {
        return missingSteps(effect, step) == 0;
    }
    /// How many steps of the air of an effect are still to be computed up to a step, of a loop all of them; more than
    /// there are steps where none is here.
    [[nodiscard]] std::int64_t missingSteps(const SampledEffect& effect, std::int64_t step) const;

private:
    std::size_t m_most;
    mutable std::mutex m_mutex;
    std::vector<std::pair<Effect, std::shared_ptr<BakedAir>>> m_airs; ///< by airPart(), the one used last at the end
};

} // namespace fumage
