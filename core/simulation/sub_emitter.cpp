#include "core/simulation/sub_emitter.h"

#include "core/base/hash.h"
#include "core/simulation/advance.h"
#include "core/simulation/frame.h"
#include "core/simulation/particle_ring.h"
#include "core/simulation/streams.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace fumage {

namespace {

/// The particles of a layer at one step that others may be born on.
class Living {
public:
    /// @param emitter of those others, which says at which share of their lives
    /// @param ofAge   room for their slots
    Living(const ParentParticles& parent, const Emitter& emitter, std::vector<std::size_t>& ofAge)
        : m_parent(parent)
        , m_ring(parent.now)
        , m_count(static_cast<std::uint64_t>(parent.last - parent.first))
        , m_isAnyAge(emitter.parentLifeFrom <= 0.0F && emitter.parentLifeTo >= 1.0F)
        , m_ofAge(ofAge)
    {
        if (!m_isAnyAge) {
            collect(emitter);
        }
    }

    /// One of them, all with the same chance; nothing where there is none. Of those whose lives differ some have died:
    /// where several draws in a row meet those, there is none.
    [[nodiscard]] std::optional<std::size_t> chosenBy(std::uint32_t key) const
    {
        if (!m_isAnyAge) {
            const std::uint64_t among = (streamBits(key, kParentStream) * std::uint64_t{m_ofAge.size()}) >> 32U;
            return m_ofAge.empty() ? std::nullopt : std::optional(m_ofAge[among]);
        }
        constexpr std::uint32_t kDraws = 8;
        for (std::uint32_t draw = 0; m_count > 0 && draw < kDraws; ++draw) {
            const std::uint64_t among = (streamBits(key, kParentStream + draw) * m_count) >> 32U;
            const std::size_t slot = m_ring.slotOf(m_parent.first + static_cast<std::int64_t>(among));
            if (isAlive(slot)) {
                return slot;
            }
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] bool isAlive(std::size_t slot) const { return cycleOf(slot).alive; }
    [[nodiscard]] Lifecycle cycleOf(std::size_t slot) const
    {
        return lifecycle(m_parent.model, m_parent.now, m_parent.step, slot);
    }
    /// Looks at all: O(particles that may be alive).
    void collect(const Emitter& emitter)
    {
        m_ofAge.clear();
        const auto [from, to] = std::minmax(emitter.parentLifeFrom, emitter.parentLifeTo);
        for (std::uint64_t i = 0; i < m_count; ++i) {
            const std::size_t slot = m_ring.slotOf(m_parent.first + static_cast<std::int64_t>(i));
            const Lifecycle cycle = cycleOf(slot);
            if (cycle.alive && cycle.life >= from && cycle.life <= to) {
                m_ofAge.push_back(slot);
            }
        }
    }

    const ParentParticles& m_parent;
    ParticleRing m_ring;
    std::uint64_t m_count;
    bool m_isAnyAge;
    std::vector<std::size_t>& m_ofAge; ///< their slots, in the order of their births, where not any age will do
};

} // namespace

void findBirthsOn(const ParentParticles& parent, const SimulationModel& child, const Emitter& emitter,
    std::int64_t first, std::int64_t last, std::vector<SubEmission>& out, std::vector<std::size_t>& ofAge)
{
    out.assign(static_cast<std::size_t>(last - first), {});
    const Living living(parent, emitter, ofAge);
    const Particles& now = parent.now;
    const float dt = child.schedule().dt;
    for (std::int64_t birth = first; birth < last; ++birth) {
        const std::uint32_t key = keyOf(emitter.seed, static_cast<std::uint64_t>(child.schedule().randomIndex(birth)));
        const std::optional<std::size_t> slot = living.chosenBy(key);
        if (!slot) {
            continue;
        }
        // What has been born in this step was nowhere before it.
        const bool isNew = now.birthStep[*slot] == static_cast<std::int32_t>(parent.step);
        const glm::vec3 here(now.x[*slot], now.y[*slot], now.z[*slot]);
        const glm::vec3 way = isNew ? dt * glm::vec3(now.vx[*slot], now.vy[*slot], now.vz[*slot])
                                    : here - glm::vec3(parent.x[*slot], parent.y[*slot], parent.z[*slot]);
        float back = child.schedule().betweenSteps ? unitFloat(key) : 0.0F;
        if (isNew) {
            back = std::min(back, parent.model.schedule().betweenSteps ? unitFloat(now.key[*slot]) : 0.0F);
        }
        out[static_cast<std::size_t>(birth - first)] = {
            here - back * way - child.effect()->emitter.position, (emitter.inherit / dt) * way, true};
    }
}

SubEmitter::SubEmitter(const SimulationModel& child)
{
    if (child.parent()->parent()) {
        m_subEmitter = std::make_unique<SubEmitter>(*child.parent());
    }
}

Status SubEmitter::moveTo(const SimulationModel& parent, std::int64_t step, const Task& task)
{
    if (m_step == step) {
        return Done{};
    }
    const std::int64_t before = step - 1;
    const bool isAhead = m_step != kNowhere && m_step <= before && before - m_step < parent.schedule().lifetimeSteps;
    Status status = isAhead ? advance(parent, m_now, m_step, before, m_subEmitter.get(), task)
                            : advanceFromNothing(parent, m_now, before, m_subEmitter.get(), task);
    m_step = kNowhere;
    if (status) {
        std::swap(m_before, m_now);
        status = advanceInto(parent, m_before, m_now, before, step, m_subEmitter.get(), task);
    }
    m_step = status ? step : kNowhere;
    return status;
}

Status SubEmitter::find(const SimulationModel& child, std::int64_t step, std::int64_t first, std::int64_t last,
    std::vector<SubEmission>& out, const Task& task)
{
    const SimulationModel& parent = *child.parent();
    const std::int64_t parentStep = child.parentStep(step);
    out.assign(static_cast<std::size_t>(last - first), {});
    if (first == last || parentStep < 0) {
        return Done{};
    }
    if (Status status = moveTo(parent, parentStep, task); !status) {
        return status;
    }
    const Schedule& schedule = parent.schedule();
    const SampledEffect& effect = child.effect();
    std::optional<SampledEffect> room; // key frames of other kinds are not read at births
    const SampledEffect& now =
        effect.isAnimated(Animates::Birth) ? child.effectAt(static_cast<double>(step), room) : effect;
    findBirthsOn({parent, m_now, m_before.x, m_before.y, m_before.z, parentStep, schedule.firstAlive(parentStep),
                     schedule.birthsBefore(parentStep + 1)},
        child, now->emitter, first, last, out, m_ofAge);
    return Done{};
}

} // namespace fumage
