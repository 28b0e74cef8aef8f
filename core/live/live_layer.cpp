#include "core/live/live_layer.h"

#include "core/base/parallel.h"
#include "core/base/vector.h"
#include "core/simulation/chunk_step.h"
#include "core/simulation/particle_ring.h"
#include "core/simulation/sub_emitter.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace fumage {

namespace {

/// Keeps the swirls where they are in the world when the place that they are counted from is moved: the part of the
/// lattice is added that it has moved by.
void anchorSwirls(StepConstants& constants, const glm::vec3& anchor)
{
    const glm::vec3 moved = (constants.pivot - anchor) * constants.turbulenceFrequency;
    for (int octave = 0; octave < constants.octaves; ++octave) {
        OctaveAtStep& at = constants.octave[static_cast<std::size_t>(octave)];
        at.shift += moved * at.frequency;
    }
}

} // namespace

LiveLayer::LiveLayer(const Emitter& emitter)
    : m_pose(poseOf(emitter))
    , m_coming(m_pose)
    , m_reached(m_pose)
    , m_target(m_pose)
    , m_anchor(m_pose.position)
{
    m_frame.step = -1;
}

void LiveLayer::setParent(LiveLayer& parent)
{
    m_parent = &parent;
    parent.m_isParent = true;
    m_model->setParent(parent.m_model);
}

void LiveLayer::setEffect(const SampledEffect& effect, std::int64_t next, std::uint32_t windSeed, const AirGrid* grid)
{
    const bool hasBegun = m_model && m_frame.step >= 0;
    // One that begins earlier than now begins now.
    const std::int64_t start =
        hasBegun ? m_model->clock().stepsBehind : std::max(-makeSchedule(effect).firstStep, next);
    const LayerClock clock{start, windSeed};
    SimulationModel model = grid != nullptr ? SimulationModel(effect, clock, *grid) : SimulationModel(effect, clock);
    model.placeEmitter(m_pose.position, m_pose.normal);
    if (hasBegun) {
        model.continueFrom(*m_model, m_frame.step);
    }
    if (m_parent != nullptr) {
        model.setParent(m_parent->m_model);
    }
    if (!m_model) {
        m_model = std::make_shared<SimulationModel>(std::move(model));
        m_frame.model = m_model;
    } else {
        *m_model = std::move(model);
    }
    if (!hasBegun) {
        m_frame.step = next - 1 - start;
    }
    m_frame.particles.setColumns(columnsOf(*m_model));
    outdate();
}

void LiveLayer::makeRoom(std::int64_t places)
{
    const auto slots = static_cast<std::size_t>(places);
    m_frame.particles.reset(slots, columnsOf(*m_model));
    if (m_isParent) {
        for (AlignedArray<float>& place : m_before) {
            place.resize(m_frame.particles.x.size());
        }
    }
    if (m_parent != nullptr) {
        m_on.reserve(slots);
        m_birthSteps.resize(slots);
    }
}

float LiveLayer::placesShare() const
{
    const auto places = static_cast<double>(m_frame.particles.capacity);
    const auto wanted = static_cast<double>(schedule().capacity());
    if (places == 0.0) {
        return 0.0F; // nobody plays it
    }
    constexpr double kRounding = 1.0; // of births to whole ones
    return places < wanted ? static_cast<float>(std::max(0.5, places - kRounding) / wanted) : 1.0F;
}

void LiveLayer::begin(std::int64_t step, double share, const KeyedPose& keyed)
{
    m_coming = between(m_reached, m_target, share);
    if (keyed.position) {
        m_coming.position = m_reached.position = m_target.position;
    }
    if (keyed.normal) {
        m_coming.normal = m_reached.normal = m_target.normal;
    }
    m_model->placeEmitter(m_coming.position, m_coming.normal);
    m_frame.step = step - m_model->clock().stepsBehind;
    m_frame.number = static_cast<int>(step / schedule().stepsPerFrame);
}

float LiveLayer::acts(float share) const
{
    return m_frame.step >= 0 && share > 0.0F ? m_clock.acts(schedule()) : 0.0F;
}

AirFeeder LiveLayer::feeder(std::int64_t step, float share) const
{
    // The air's step 0 is its first: what acts in it is what acts after step 0.
    const float now = step == 0 ? acts(share) : m_acted;
    const std::int64_t number = std::max<std::int64_t>(1, step) - m_model->clock().stepsBehind;
    return {m_model.get(), number, effect()->source.feeds ? now : 0.0F};
}

void LiveLayer::plan(const AirField* air)
{
    if (m_frame.step < 0) {
        return;
    }
    findParts(*m_model, m_frame.step, air, m_parts);
    for (StepConstants& part : m_parts) {
        anchorSwirls(part, m_anchor);
    }
}

void LiveLayer::move(float share)
{
    m_acted = acts(share);
    if (m_frame.step >= 0) {
        if (m_isParent) {
            const Particles& now = m_frame.particles;
            std::copy(now.x.begin(), now.x.end(), m_before[0].begin());
            std::copy(now.y.begin(), now.y.end(), m_before[1].begin());
            std::copy(now.z.begin(), now.z.end(), m_before[2].begin());
        }
        retire();
        const std::int64_t births = countBirths(share);
        if (m_parent != nullptr) {
            findBirths(births);
        }
        moveParticles(births);
    }
    m_pose = m_coming;
    outdate();
}

std::int64_t LiveLayer::birthStepOf(std::size_t slot) const
{
    return m_parent != nullptr ? m_birthSteps[slot] : m_frame.particles.birthStep[slot];
}

void LiveLayer::retire()
{
    Particles& particles = m_frame.particles;
    const ParticleRing ring(particles);
    const std::int64_t lifetime = schedule().lifetimeSteps;
    while (m_first < m_next && birthStepOf(ring.slotOf(m_first)) + lifetime <= m_frame.step) {
        const std::size_t slot = ring.slotOf(m_first);
        m_absent -= particles.birthStep[slot] == Particles::kUnborn ? 1 : 0;
        particles.clear(slot, slot + 1);
        ++m_first;
    }
}

std::int64_t LiveLayer::countBirths(float share)
{
    const std::int64_t births = m_clock.next(schedule(), share);
    const auto places = static_cast<std::int64_t>(m_frame.particles.capacity) - (m_next - m_first);
    return std::min(births, places);
}

void LiveLayer::findBirths(std::int64_t births)
{
    const LiveLayer& parent = *m_parent;
    if (parent.m_frame.step < 0) {
        m_on.assign(static_cast<std::size_t>(births), {});
    } else {
        m_ofAge.reserve(parent.particles().capacity);
        const auto& [x, y, z] = parent.m_before;
        findBirthsOn({*parent.m_model, parent.particles(), x, y, z, parent.m_frame.step, parent.m_first, parent.m_next},
            *m_model, effect()->emitter, m_next, m_next + births, m_on, m_ofAge);
    }
    const ParticleRing ring(m_frame.particles);
    for (std::int64_t birth = 0; birth < births; ++birth) {
        m_birthSteps[ring.slotOf(m_next + birth)] = static_cast<std::int32_t>(m_frame.step);
        m_absent += m_on[static_cast<std::size_t>(birth)].isThere ? 0 : 1;
    }
}

void LiveLayer::moveParticles(std::int64_t births)
{
    const glm::vec3 velocity = m_coming.velocity / effect()->timeline.timeScale;
    EmitterTravel travel{m_coming.position - m_pose.position, m_pose.normal, velocity, m_parts.front().betweenSteps};
    if (areAlmostOpposite(travel.normalBefore, m_coming.normal)) {
        travel.normalBefore = m_coming.normal;
    }
    if (m_parent != nullptr) {
        travel.way = travel.velocity = glm::vec3(0.0F); // they come with what they are born on
    }
    const Spawner place(effect()->emitter, travel);
    Particles& particles = m_frame.particles;
    const ParticleRing ring(particles);
    const std::int64_t end = m_next + births;
    parallelFor(particles.chunks(), [&](std::size_t chunk) {
        const bool lives = ring.reaches(chunk, m_first, m_next);
        if (lives) {
            moveChunk(m_parts, particles, chunk);
        }
        ring.forChunk(chunk, m_next, end, [&](std::int64_t low, std::int64_t high, std::size_t slot) {
            const auto count = static_cast<std::size_t>(high - low);
            const std::span<const SubEmission> on = m_parent == nullptr
                ? std::span<const SubEmission>()
                : std::span(m_on).subspan(static_cast<std::size_t>(low - m_next), count);
            spawnInChunk(place, m_parts, low, slot, slot + count, on, particles);
        });
        if (lives || ring.reaches(chunk, m_next, end)) {
            ring.clearOthers(particles, chunk, m_first, end); // moved too, though nobody lives there
        }
    });
    m_next = end;
}

void LiveLayer::outdate()
{
    m_appearanceIsNew = false;
    m_coloursAreNew = false;
}

const Appearance& LiveLayer::appearance()
{
    if (!m_appearanceIsNew) {
        findAppearance(m_frame, effect(), Axes{}, m_appearance);
        m_appearanceIsNew = true;
    }
    return m_appearance;
}

std::span<const float> LiveLayer::ages()
{
    const Particles& particles = m_frame.particles;
    m_ages.resize(particles.capacity);
    for (std::size_t slot = 0; slot < m_ages.size(); ++slot) {
        m_ages[slot] =
            particles.birthStep[slot] == Particles::kUnborn ? 0.0F : std::max(0.0F, lifecycle(m_frame, slot).age);
    }
    return m_ages;
}

std::span<const std::uint64_t> LiveLayer::ids()
{
    const Particles& particles = m_frame.particles;
    m_ids.assign(particles.capacity, kNobody);
    const ParticleRing ring(particles);
    for (std::int64_t index = m_first; index < m_next; ++index) {
        const std::size_t slot = ring.slotOf(index);
        m_ids[slot] = particles.birthStep[slot] == Particles::kUnborn ? kNobody : static_cast<std::uint64_t>(index);
    }
    return m_ids;
}

std::span<const glm::vec4> LiveLayer::colours()
{
    const Appearance& looks = appearance();
    if (m_coloursAreNew) {
        return m_colours;
    }
    const std::array<glm::vec3, kColourTableSize> table = coloursOverLife(effect()->look);
    m_colours.resize(looks.life.size());
    for (std::size_t i = 0; i < m_colours.size(); ++i) {
        m_colours[i] = glm::vec4(
            table[static_cast<std::size_t>(looks.life[i] * static_cast<float>(kColourTableSize - 1))], looks.alpha[i]);
    }
    m_coloursAreNew = true;
    return m_colours;
}

} // namespace fumage
