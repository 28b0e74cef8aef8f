#include "core/simulation/simulation_model.h"

#include "core/base/hash.h"
#include "core/base/math.h"
#include "core/base/random_place.h"
#include "core/base/vector.h"
#include "core/simulation/air_source.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace fumage {

namespace {

// Streams of the random numbers that belong to the whole effect and not to a particle.
enum EffectStream : std::uint32_t {
    kGustStrength = 101,
    kGustAngle = 102,
    kRotation = 103,
    kTurbulence = 104,
    kRings = 120
};

/// Gusts turn the wind by at most this, degrees.
constexpr float kGustAngleRange = 60.0F;

/// Speed of the swirls below the grid, root mean square, over the root of the sum of the squares of the air's
/// differences from cell to cell.
constexpr float kDetailPerShear = 0.5F;

/// Rates of eddies grow with the 2/3 power of their wave number (Kolmogorov 1941).
constexpr float kTurnoverExponent = 2.0F / 3.0F;

/// Of the first octave, per component, so that all octaves together have the root mean square speed that is asked:
/// their squares add.
float firstAmplitude(const Turbulence& turbulence)
{
    float squares = 0.0F;
    float square = 1.0F;
    for (int octave = 0; octave < turbulence.octaves; ++octave) {
        squares += square;
        square *= turbulence.roughness * turbulence.roughness;
    }
    constexpr float kComponents = 3.0F;
    return turbulence.strength / std::sqrt(kComponents * squares);
}

/// How much faster swirls change that are of another size.
float fasterIn(float scale, float wanted)
{
    return portablePow(scale / wanted, kTurnoverExponent);
}

/// What is left of turbulence below a grid: it begins where the grid ends, goes on changing as fast as its sizes do,
/// and takes its strength from the air.
Turbulence belowTheGrid(const Turbulence& whole, float cell, float detail)
{
    Turbulence part = whole;
    part.scale = 2.0F * cell;
    part.strength = detail > 0.0F ? 1.0F : 0.0F;
    part.evolution = whole.evolution * fasterIn(whole.scale, part.scale);
    part.onset = 0.0F;
    part.growth = 0.0F;
    return part;
}

/// Below this the differences of exponentials would cancel, and series of six terms leave less than a float sees.
constexpr float kSmallDrag = 0.1F;

/// (dt - tau) / (D dt) with tau as below: what drag takes of the way of a step's acceleration.
float lackingOfTau(float drag, float dt)
{
    const float x = drag * dt;
    if (x > kSmallDrag) {
        return (1.0F - (1.0F - portableExp(-x)) / x) / drag;
    }
    return dt * 0.5F * (1.0F - x / 3.0F * (1.0F - x / 4.0F * (1.0F - x / 5.0F * (1.0F - x / 6.0F))));
}

/// tau = (1 - e^(-D dt)) / D, by which a step's acceleration is multiplied: the exact solution of V' = a - D V is V +
/// (a - D V) tau.
float draggedTime(float drag, float dt)
{
    const float x = drag * dt;
    if (x > kSmallDrag) {
        return (1.0F - portableExp(-x)) / drag;
    }
    return dt * (1.0F - x / 2.0F * (1.0F - x / 3.0F * (1.0F - x / 4.0F * (1.0F - x / 5.0F * (1.0F - x / 6.0F)))));
}

/// @param tau draggedTime()
void setDrag(float drag, float dt, float tau, StepConstants& out)
{
    out.drag = drag * tau;
    if (drag > 0.0F) {
        // V tau + a (dt - tau) / D, with a from the velocities at either end.
        out.dragOfStep = drag * dt;
        out.flightAfter = lackingOfTau(drag, dt) / tau;
        out.flightBefore = tau / dt - out.flightAfter * (1.0F - out.drag);
    }
}

} // namespace

SimulationModel::SimulationModel(const SampledEffect& effect, std::shared_ptr<BakedAir> air)
    : SimulationModel(effect, LayerClock{0, effect->emitter.seed}, std::move(air))
{
}

SimulationModel::SimulationModel(const SampledEffect& effect, const LayerClock& clock, std::shared_ptr<BakedAir> air)
    : m_effect(effect)
    , m_clock(clock)
    , m_schedule(makeSchedule(m_effect))
    , m_pace{m_effect->turbulence.drift, m_effect->turbulence.evolution}
    , m_air(std::move(air))
    , m_changes(
          effect.isAnimated(Animates::Step) || effect.isAnimated(Animates::Birth) || effect.isAnimated(Animates::Rate))
{
    if (m_air) {
        m_grid = m_air->plan().grid;
    }
    sumRates();
}

SimulationModel::SimulationModel(const SampledEffect& effect, const AirGrid& grid)
    : SimulationModel(effect, LayerClock{0, effect->emitter.seed}, grid)
{
}

SimulationModel::SimulationModel(const SampledEffect& effect, const LayerClock& clock, const AirGrid& grid)
    : m_effect(effect)
    , m_clock(clock)
    , m_schedule(makeSchedule(m_effect))
    , m_pace{m_effect->turbulence.drift, m_effect->turbulence.evolution}
    , m_grid(grid)
{
}

float SimulationModel::gustAt(double step, std::uint32_t stream) const
{
    const double time = std::max(0.0, step + static_cast<double>(m_clock.stepsBehind));
    const RowPosition row = m_gusts
        ? m_gusts->row(time, m_schedule)
        : rowPosition(time, m_schedule, static_cast<double>(m_effect->wind.gustRate * m_schedule.dt));
    const std::uint32_t seed = streamBits(m_clock.windSeed, stream);
    const float a = signedFloat(keyOf(seed, static_cast<std::uint64_t>(row.before)));
    const float b = signedFloat(keyOf(seed, static_cast<std::uint64_t>(row.after)));
    return a + (b - a) * smoothStep(row.fraction);
}

glm::vec3 SimulationModel::windAt(double step) const
{
    std::optional<SampledEffect> room;
    const Wind& wind = effectAt(step, room)->wind;
    const float strength = wind.strength * (1.0F + wind.gust * gustAt(step, kGustStrength));
    const float angle = wind.angle + wind.gust * kGustAngleRange * gustAt(step, kGustAngle);
    return strength * horizontalDirection(angle);
}

float SimulationModel::drawScale() const
{
    return std::sqrt(static_cast<float>(m_schedule.stepsPerFrame));
}

float SimulationModel::rotationAt(std::int64_t step) const
{
    const std::uint32_t bits =
        streamBits(stepKey(m_effect->emitter.seed, static_cast<std::uint64_t>(m_schedule.randomStep(step))), kRotation);
    std::optional<SampledEffect> room;
    const Motion& motion = effectAt(static_cast<double>(step), room)->motion;
    return radians(motion.rotation + motion.rotationJitter * drawScale() * signedFloat(bits)) * m_schedule.dt;
}

OctaveAtStep SimulationModel::octaveAt(const Turbulence& turbulence, float faster, std::int64_t step, int octave) const
{
    const auto order = static_cast<float>(octave);
    OctaveAtStep out;
    out.frequency = portablePow(turbulence.lacunarity, order);
    const float amplitude = firstAmplitude(turbulence) * portablePow(turbulence.roughness, order) * kCurlNormalisation;
    const std::uint32_t seed = streamBits(m_effect->emitter.seed, kTurbulence + static_cast<std::uint32_t>(octave));
    constexpr int kLarge = 2; // smaller swirls shear a particle rather than turn it
    out.turns = octave < kLarge;
    const float turnover = portablePow(out.frequency, kTurnoverExponent);
    const double cellsPerStep = static_cast<double>(turbulence.evolution * turnover * m_schedule.dt);
    const RowPosition row = evolvedTo(step, cellsPerStep, static_cast<double>(faster) * static_cast<double>(turnover));
    const Drift drift = driftedTo(turbulence.drift, step, static_cast<double>(out.frequency / turbulence.scale));
    const double whole = std::floor(drift.now);
    // Random, or a corner of every octave's lattice would stand in the emitter's centre, where all gradients are 0: as
    // one body it would move.
    out.shift = randomInUnitCube(seed, 1);
    out.shift.y += static_cast<float>(whole - drift.now);

    if (!evolves()) {
        out.slices.key[0] = streamBits(seed, 0);
        out.slices.weight[0] = amplitude;
        out.slices.shift[0] = latticeShift(static_cast<std::int64_t>(whole));
        return out;
    }
    // Counted from where a slice begins, and on through the end of a loop. It may be counted from anywhere that is the
    // same at all steps: where rates change, from where it would begin if they had stayed as they are without.
    const auto shiftOf = [&](std::int64_t slice) {
        const auto cell = static_cast<double>(slice);
        const double before = row.cells != 0 ? drift.inLoop * cell / static_cast<double>(row.cells)
            : cellsPerStep > 0.0             ? drift.perStep / cellsPerStep * cell
                                             : 0.0;
        return latticeShift(static_cast<std::int64_t>(whole - std::floor(before)));
    };
    const float blend = 0.5F * kPi * smoothStep(row.fraction);
    out.slices.key = {
        keyOf(seed, static_cast<std::uint64_t>(row.before)), keyOf(seed, static_cast<std::uint64_t>(row.after))};
    // Sine and cosine keep the variance of the sum constant while the slices cross-fade.
    out.slices.weight = {amplitude * portableCos(blend), amplitude * portableSin(blend)};
    out.slices.shift = {shiftOf(row.before), shiftOf(row.before + 1)};
    return out;
}

void SimulationModel::placeRings(const Effect& now, std::int64_t step, StepConstants& out) const
{
    const Rings& rings = now.rings;
    const auto spacing = static_cast<double>(rings.spacing);
    const double passed = ringsPassed(step, out);
    out.ringStrength = rings.strength;
    out.ringRadius = rings.radius;
    out.ringWidening = rings.widening;
    out.ringsPerMetre = 1.0F / rings.spacing;
    out.ringCentre = static_cast<float>((passed - std::floor(passed)) * spacing);
    out.ringNumber = static_cast<float>(std::floor(passed));
    // Warm smoke has rings all the way up; otherwise the first one leaves at step 0.
    out.ringsLead = m_schedule.firstStep <= 0;
    out.ringFollowers = rings.followers;
    out.ringVariance = rings.variance;
    out.ringKey = streamBits(now.emitter.seed, kRings);
    out.ringAxis = glm::normalize(now.emitter.normal);
    const PlaneBasis plane = planeBasis(out.ringAxis);
    out.ringSides = {-plane.along, -plane.across};
}

void SimulationModel::setParent(std::shared_ptr<const SimulationModel> parent)
{
    m_parent = std::move(parent);
    m_parentAhead = m_clock.stepsBehind - m_parent->clock().stepsBehind;
    const std::int64_t loop = m_schedule.loopSteps;
    const std::int64_t early = m_parent->schedule().firstStep - m_parentAhead;
    if (loop > 0 && early > 0) {
        m_parentAhead += (early + loop - 1) / loop * loop;
    }
}

StepConstants SimulationModel::constants(std::int64_t step, float share) const
{
    std::optional<SampledEffect> room;
    const Effect& now = effectAt(static_cast<double>(step), room);
    const Motion& motion = now.motion;
    const float dt = m_schedule.dt * share;
    const float r = motion.randomness;
    const float tau = draggedTime(motion.drag, dt);

    StepConstants out;
    out.key = stepKey(now.emitter.seed, static_cast<std::uint64_t>(m_schedule.randomStep(step)));
    out.dt = dt;
    out.step = static_cast<std::int32_t>(step);
    out.share = share;
    out.betweenSteps = m_schedule.betweenSteps;
    const glm::vec3 gravity{0.0F, motion.gravity / motion.mass, 0.0F};
    const glm::vec3 acceleration = inAir()
        ? -gravity
        : windAt(static_cast<double>(step)) - gravity; // where there is air, it is what the wind moves
    out.steady = acceleration * ((1.0F - r) * tau);
    out.random = acceleration * (r * drawScale() * tau * 0x1p-31F);
    out.steadyShare = 1.0F - r;
    out.randomShare = r * drawScale() * 0x1p-31F;
    // of air: its share of a particle's own heat
    out.buoyancy = (inAir() ? now.air.buoyancy : motion.buoyancy) * tau;
    out.cooling = motion.cooling;
    out.heatVariance = motion.heatVariance;
    out.pull = motion.pull * tau;
    setDrag(motion.drag, dt, tau, out);
    out.pivot = now.emitter.position;
    if (motion.rotation != 0.0F || motion.rotationJitter != 0.0F) {
        out.rotation = rotationAt(step) * share;
        out.rotationSin = portableSin(out.rotation);
        out.rotationCos = portableCos(out.rotation);
    }
    out.vortexStrength = now.vortex.strength;
    out.vortexRadius = now.vortex.radius;
    out.vortexWidening = now.vortex.widening;
    out.vortexAxis = now.vortex.axis;
    if (now.rings.strength > 0.0F && !inAir()) {
        placeRings(now, step, out); // air makes its own
    }
    placeTurbulence(now, step, out);
    out.plain = motion.buoyancy == 0.0F && motion.pull == 0.0F && motion.drag == 0.0F && motion.rotation == 0.0F
        && motion.rotationJitter == 0.0F && out.vortexStrength == 0.0F && out.ringStrength == 0.0F && out.octaves == 0
        && !inAir();
    if (inAir()) {
        placeAir(now, out);
    }
    return out;
}

void SimulationModel::placeTurbulence(const Effect& now, std::int64_t step, StepConstants& out) const
{
    Turbulence turbulence = now.turbulence;
    turbulence.drift = m_pace.drift;
    turbulence.evolution = m_pace.evolution;
    float faster = 1.0F;
    if (m_grid) {
        turbulence = belowTheGrid(turbulence, m_grid->cell, now.turbulence.detail);
        faster = fasterIn(now.turbulence.scale, turbulence.scale);
    }
    out.octaves = turbulence.strength > 0.0F ? turbulence.octaves : 0;
    out.turbulenceFrequency = 1.0F / turbulence.scale;
    out.onset = turbulence.onset;
    out.growth = turbulence.growth;
    for (int octave = 0; octave < out.octaves; ++octave) {
        out.octave[static_cast<std::size_t>(octave)] = octaveAt(turbulence, faster, step, octave);
    }
}

void SimulationModel::placeAir(const Effect& now, StepConstants& out) const
{
    const Air& air = now.air;
    const AirGrid& grid = *m_grid;
    constexpr float kShareOfBox = 0.25F;
    out.air.reach = kShareOfBox * grid.cell * static_cast<float>(std::max({grid.cells.x, grid.cells.y, grid.cells.z}));
    out.air.detail = now.turbulence.detail * kDetailPerShear;
    out.air.sourceDepth = sourceDepth(now.emitter, grid);
    out.air.sourceSides = sourceSides(now.emitter);
    out.air.sourceVelocity = sourceVelocity(now.emitter);
    out.air.bornOnPicture = isOnPicture(now.emitter);
    out.air.hasGround = air.ground;
    out.air.groundHeight = air.groundHeight;
    out.air.obstacle = air.obstacle;
    out.air.obstaclePosition = air.obstaclePosition;
    out.air.obstacleHalf = 0.5F * air.obstacleSize;
    if (m_parent) {
        out.air.bornOnParent = true;
        out.air.sourceVelocity = glm::vec3(0.0F);
    }
    out.air.coupling = now.motion.coupling;
    if (out.air.coupling != Coupling::Carried) {
        out.buoyancy = 0.0F; // heat lifts smoke
        out.air.restitution = now.motion.restitution;
        out.air.friction = now.motion.friction;
    }
    out.air.shapeLost = 1.0F - portableExp(-out.dt / now.look.deformationTime);
}

} // namespace fumage
