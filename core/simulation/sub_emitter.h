#pragma once

#include "core/simulation/particles.h"
#include "core/simulation/sub_emission.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace fumage {

/// The particles of a layer at one of its steps, for those that are born on them, and where they were a step before.
struct ParentParticles {
    const SimulationModel& model;
    const Particles& now;
    std::span<const float> x, y, z; ///< before, one a slot, m
    std::int64_t step = 0;
    std::int64_t first = 0; ///< births [first, last) are those that may be alive
    std::int64_t last = 0;
};

/// Finds where births [first, last) of a layer are on its parent: each on one of the living, chosen by its own random
/// bits, at the moment of its birth between two steps.
/// @param emitter of the layer at the step of the births
/// @param out     gets one a birth
/// @param ofAge   room for the parent's slots, kept from one call to the next
/// O(births); where the parent's age matters, O(births + the parent's particles).
void findBirthsOn(const ParentParticles& parent, const SimulationModel& child, const Emitter& emitter,
    std::int64_t first, std::int64_t last, std::vector<SubEmission>& out, std::vector<std::size_t>& ofAge);

/// Finds where particles are born that are born on those of another layer, see findBirthsOn(). Moves the parent beside
/// its child.
///
/// A pure function of the child's model and the step, whatever was asked before. Births that follow one another cost
/// the parent's steps; a jump costs at most one lifetime of it. Not thread-safe; uses all threads inside.
class SubEmitter : public SubEmissionSource {
public:
    /// @param child with a parent; see SimulationModel::setParent()
    explicit SubEmitter(const SimulationModel& child);

    [[nodiscard]] Status find(const SimulationModel& child, std::int64_t step, std::int64_t first, std::int64_t last,
        std::vector<SubEmission>& out, const Task& task) override;

private:
    [[nodiscard]] Status moveTo(const SimulationModel& parent, std::int64_t step, const Task& task);

    std::unique_ptr<SubEmitter> m_subEmitter; ///< of the parent's own births, where it is born on yet another layer
    Particles m_before; ///< the parent's, a step before
    Particles m_now;
    std::vector<std::size_t> m_ofAge; ///< see findBirthsOn()
    std::int64_t m_step = kNowhere; ///< of m_now

    static constexpr std::int64_t kNowhere = -1;
};

} // namespace fumage
