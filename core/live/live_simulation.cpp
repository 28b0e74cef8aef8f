#include "core/live/live_simulation.h"

#include "core/base/parallel.h"
#include "core/effect/known_parameter.h"
#include "core/effect/parameter_table.h"
#include "core/simulation/air_plan.h"
#include "core/simulation/chunk_step.h"
#include "core/simulation/particle_ring.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <glm/geometric.hpp>

namespace fumage {

namespace {

/// An effect as it is simulated here: endless, and from nothing.
Effect endless(const Effect& effect)
{
    Effect out = effect;
    out.timeline.loop = false;
    out.timeline.prewarm = false;
    return out;
}

/// An effect in steps that somebody else chooses; 0: in its own.
Effect inSteps(const Effect& effect, int stepsPerSecond)
{
    Effect out = effect;
    if (stepsPerSecond > 0) {
        out.timeline.frameRate = stepsPerSecond;
        out.timeline.stepsPerFrame = 1;
    }
    return out;
}

/// The first parameter that differs and is fixed as long as a simulation runs; without air, nothing of it is. Null:
/// none.
const Parameter* fixedDifference(const Effect& now, const Effect& wanted)
{
    for (const Parameter& parameter : parameterTable()) {
        const bool matters =
            parameter.group() != "air" || now.air.enabled || &parameter == &knownParameter("air.enabled");
        if (parameter.live == Live::Fixed && matters && parameter.get(now) != parameter.get(wanted)) {
            return &parameter;
        }
    }
    return nullptr;
}

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

/// As many frames a second as an effect has at most.
constexpr int kMaxStepsPerSecond = 240;

double secondsOfMachine()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Status checkOptions(const LiveOptions& options)
{
    if (options.mostParticles < 0 || options.mostParticles > kMaxParticles) {
        return Error{ErrorCode::TooLarge, makeMessage("%1 particles are not possible", options.mostParticles), {},
            makeMessage("Ask for 1 to %1, or 0 for as many as the effect has", kMaxParticles)};
    }
    if (options.stepsPerSecond < 0 || options.stepsPerSecond > kMaxStepsPerSecond) {
        return Error{ErrorCode::OutOfRange, makeMessage("%1 steps a second are not possible", options.stepsPerSecond),
            {}, makeMessage("Ask for 1 to %1, or 0 for those of the effect", kMaxStepsPerSecond)};
    }
    if (options.mostStepsAtOnce < 1 || !(options.budgetMs >= 0.0)) {
        return Error{ErrorCode::OutOfRange,
            makeMessage("a budget below 0 or less than one step at once is not possible"), {},
            makeMessage("Ask for 0 ms or more, and for 1 step or more")};
    }
    return Done{};
}

} // namespace

Result<LiveSimulation> LiveSimulation::start(const Effect& effect, const LiveOptions& options)
{
    if (Status status = checkOptions(options); !status) {
        return status.error();
    }
    const Effect timed = inSteps(effect, options.stepsPerSecond);
    if (Status status = checkAir(sampled(endless(timed))); !status) {
        return status.error();
    }
    return LiveSimulation(timed, options);
}

LiveSimulation::LiveSimulation(const Effect& effect, const LiveOptions& options)
    : m_effect(effect)
    , m_options(options)
    , m_stepSeconds(1.0 / (static_cast<double>(effect.timeline.frameRate) * effect.timeline.stepsPerFrame))
    , m_pose(poseOf(effect.emitter))
    , m_reached(m_pose)
    , m_target(m_pose)
    , m_anchor(m_pose.position)
{
    if (effect.air.enabled) {
        m_air = std::make_unique<LiveAir>(SimulationModel(sampled(endless(effect))));
    }
    m_model = std::make_shared<SimulationModel>(makeModel());
    if (options.budgetMs > 0.0) {
        constexpr double kSecondsPerMs = 1e-3;
        m_budget.emplace(options.budgetMs * kSecondsPerMs);
        if (!m_options.clock) {
            m_options.clock = secondsOfMachine;
        }
    }
    const std::int64_t most = options.mostParticles > 0 ? options.mostParticles : m_model->schedule().capacity();
    m_frame.model = m_model;
    m_frame.step = -1;
    m_frame.particles.reset(static_cast<std::size_t>(most), columnsOf(*m_model));
}

SimulationModel LiveSimulation::makeModel() const
{
    const SampledEffect effect = sampled(endless(m_effect));
    SimulationModel model = m_air ? SimulationModel(effect, m_air->grid()) : SimulationModel(effect);
    model.placeEmitter(m_pose.position, m_pose.normal);
    return model;
}

Result<int> LiveSimulation::step(double seconds)
{
    if (!(seconds >= 0.0) || !std::isfinite(seconds)) {
        return Error{ErrorCode::OutOfRange, makeMessage("time that goes back, or is no number, is not possible"), {},
            makeMessage("Pass the seconds since the last step, 0 or more")};
    }
    // More than a year is let go in any case, and would end in infinities.
    constexpr double kLongest = 4e7; // s
    seconds = std::min(seconds, kLongest);
    // A game's 1/60 as a float is a hair away from a step: without this there would now and then be none, and two the
    // next time.
    constexpr double kRoundingOfFloats = 1e-6;
    const double before = m_saved;
    const double due = (before + seconds) / m_stepSeconds;
    const double whole = std::floor(due + kRoundingOfFloats);
    const int steps = static_cast<int>(std::min(whole, static_cast<double>(m_options.mostStepsAtOnce)));
    // time that is let go takes its part of the emitter's way with it
    const double stretch = steps > 0 ? whole / steps : 1.0;
    for (int i = 1; i <= steps; ++i) {
        const double share = seconds > 0.0 ? (i * stretch * m_stepSeconds - before) / seconds : 1.0;
        const bool isNow = share > 1.0 - kRoundingOfFloats;
        stepOnce(between(m_reached, m_target, isNow ? 1.0 : std::max(0.0, share)));
    }
    m_saved = (due - whole) * m_stepSeconds;
    m_reached = m_target;
    return steps;
}

void LiveSimulation::stepOnce(const EmitterPose& pose)
{
    const auto now = [&] { return m_budget ? m_options.clock() : 0.0; };
    const double start = now();
    const std::int64_t step = m_frame.step + 1;
    m_model->placeEmitter(pose.position, pose.normal);
    if (m_air) {
        const float acts = share() > 0.0F ? m_clock.acts(m_model->schedule()) : 0.0F;
        m_air->step(*m_model, step, step == 0 ? acts : m_acted);
        m_acted = acts;
    }
    findParts(*m_model, step, m_air ? &m_air->field() : nullptr, m_parts);
    for (StepConstants& part : m_parts) {
        anchorSwirls(part, m_anchor);
    }
    const double afterAir = now();
    retire(step);
    moveParticles(pose, countBirths());
    m_pose = pose;
    m_frame.step = step;
    m_frame.number = static_cast<int>(step / m_model->schedule().stepsPerFrame);
    outdate();
    if (m_budget) {
        (void)m_budget->observe(
            {afterAir - start, now() - afterAir}, living(), static_cast<std::size_t>(m_model->effect()->emitter.count));
    }
}

void LiveSimulation::retire(std::int64_t step)
{
    const ParticleRing ring(m_frame.particles);
    const std::int64_t lifetime = m_model->schedule().lifetimeSteps;
    while (m_first < m_next && m_frame.particles.birthStep[ring.slotOf(m_first)] + lifetime <= step) {
        const std::size_t slot = ring.slotOf(m_first);
        m_frame.particles.clear(slot, slot + 1);
        ++m_first;
    }
}

std::int64_t LiveSimulation::countBirths()
{
    const std::int64_t births = m_clock.next(m_model->schedule(), share());
    const auto places = static_cast<std::int64_t>(m_frame.particles.capacity) - (m_next - m_first);
    return std::min(births, places);
}

void LiveSimulation::moveParticles(const EmitterPose& pose, std::int64_t births)
{
    EmitterTravel travel{pose.position - m_pose.position, m_pose.normal, pose.velocity, m_parts.front().betweenSteps};
    if (isFlip(travel.normalBefore, pose.normal)) {
        travel.normalBefore = pose.normal;
    }
    const Spawner place(m_model->effect()->emitter, travel);
    Particles& particles = m_frame.particles;
    const ParticleRing ring(particles);
    const std::int64_t end = m_next + births;
    parallelFor(particles.chunks(), [&](std::size_t chunk) {
        const bool lives = ring.reaches(chunk, m_first, m_next);
        if (lives) {
            moveChunk(m_parts, particles, chunk);
        }
        ring.forChunk(chunk, m_next, end, [&](std::int64_t low, std::int64_t high, std::size_t slot) {
            spawnInChunk(place, m_parts, low, slot, slot + static_cast<std::size_t>(high - low), {}, particles);
        });
        if (lives || ring.reaches(chunk, m_next, end)) {
            ring.clearOthers(particles, chunk, m_first, end); // moved too, though nobody lives there
        }
    });
    m_next = end;
}

Status LiveSimulation::setEffect(const Effect& wanted)
{
    const Effect effect = inSteps(wanted, m_options.stepsPerSecond);
    if (const Parameter* fixed = fixedDifference(m_effect, effect)) {
        return Error{ErrorCode::OutOfRange, makeMessage("%1 is fixed while the simulation runs", fixed->key),
            std::string(fixed->key), makeMessage("Keep it, or start a new simulation")};
    }
    if (effect.emitter.position != m_effect.emitter.position) {
        m_target.position = effect.emitter.position;
    }
    if (effect.emitter.normal != m_effect.emitter.normal) {
        m_target.normal = glm::normalize(effect.emitter.normal);
    }
    m_effect = effect;
    *m_model = makeModel();
    m_frame.particles.setColumns(columnsOf(*m_model));
    outdate();
    return Done{};
}

Status LiveSimulation::setEmitter(const EmitterPose& pose)
{
    const Result<EmitterPose> target = checkedPose(pose);
    if (!target) {
        return target.error();
    }
    m_target = target.value();
    return Done{};
}

Status LiveSimulation::placeEmitter(const EmitterPose& pose)
{
    if (Status status = setEmitter(pose); !status) {
        return status;
    }
    m_reached = m_target;
    m_pose = m_target;
    return Done{};
}

void LiveSimulation::setShare(float share)
{
    m_share = share > 0.0F ? std::min(share, 1.0F) : 0.0F;
}

float LiveSimulation::share() const
{
    return m_share * std::min(m_budget ? m_budget->share() : 1.0F, placesShare());
}

float LiveSimulation::placesShare() const
{
    const auto places = static_cast<double>(m_frame.particles.capacity);
    const auto wanted = static_cast<double>(m_model->schedule().capacity());
    constexpr double kRounding = 1.0; // of births to whole ones
    return places < wanted ? static_cast<float>(std::max(0.5, places - kRounding) / wanted) : 1.0F;
}

void LiveSimulation::outdate()
{
    m_appearanceIsNew = false;
    m_coloursAreNew = false;
    if (m_light) {
        m_light->outdate();
    }
}

const Appearance& LiveSimulation::appearance()
{
    if (!m_appearanceIsNew) {
        findAppearance(m_frame, m_model->effect(), Axes{}, m_appearance);
        m_appearanceIsNew = true;
    }
    return m_appearance;
}

std::span<const float> LiveSimulation::ages()
{
    const Particles& particles = m_frame.particles;
    m_ages.resize(particles.capacity);
    for (std::size_t slot = 0; slot < m_ages.size(); ++slot) {
        m_ages[slot] =
            particles.birthStep[slot] == Particles::kUnborn ? 0.0F : std::max(0.0F, lifecycle(m_frame, slot).age);
    }
    return m_ages;
}

std::span<const std::uint64_t> LiveSimulation::ids()
{
    m_ids.assign(m_frame.particles.capacity, kNobody);
    const ParticleRing ring(m_frame.particles);
    for (std::int64_t index = m_first; index < m_next; ++index) {
        m_ids[ring.slotOf(index)] = static_cast<std::uint64_t>(index);
    }
    return m_ids;
}

std::span<const glm::vec4> LiveSimulation::colours()
{
    const Appearance& looks = appearance();
    if (m_coloursAreNew) {
        return m_colours;
    }
    const std::array<glm::vec3, kColourTableSize> table = coloursOverLife(m_effect.look);
    m_colours.resize(looks.life.size());
    for (std::size_t i = 0; i < m_colours.size(); ++i) {
        m_colours[i] = glm::vec4(
            table[static_cast<std::size_t>(looks.life[i] * static_cast<float>(kColourTableSize - 1))], looks.alpha[i]);
    }
    m_coloursAreNew = true;
    return m_colours;
}

LiveLight& LiveSimulation::light()
{
    if (!m_light) {
        m_light = std::make_unique<LiveLight>();
    }
    return *m_light;
}

Result<std::span<const glm::vec4>> LiveSimulation::litColours(const std::optional<glm::vec3>& eye)
{
    return light().colours(m_frame, sampledEffect(), eye);
}

Result<std::span<const glm::vec3>> LiveSimulation::normals()
{
    return light().normals(m_frame, sampledEffect());
}

} // namespace fumage
