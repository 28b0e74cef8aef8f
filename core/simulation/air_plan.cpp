#include "core/simulation/air_plan.h"

#include "core/base/hash.h"
#include "core/base/math.h"
#include "core/simulation/model.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace fumage {

namespace {

/// Streams of the random numbers of the air.
enum AirStream : std::uint32_t {
    kRim = 140,
    kStirring = 150
};

/// Drag, 1/s, below which the wind is as fast as if there were this much: without any it would have no speed of its own.
constexpr float kLeastWindDrag = 0.5F;

/// How soon the air in the source has the emitter's speed, 1/s.
constexpr float kGrip = 30.0F;

/// Radius of the source, seen from along its normal: of a rectangle, that of a disc of the same area.
float radiusOf(const Emitter& emitter)
{
    return emitter.shape == EmitterShape::Rectangle ? std::sqrt(emitter.width * emitter.depth / kPi) : emitter.radius;
}

/// Half its edges, or its radius twice, m.
glm::vec2 reachOf(const Emitter& emitter)
{
    return emitter.shape == EmitterShape::Rectangle ? glm::vec2(0.5F * emitter.width, 0.5F * emitter.depth) : glm::vec2(emitter.radius);
}

/// The wind's speed: that at which drag balances its acceleration, as for a lone particle.
glm::vec3 windSpeed(const glm::vec3& acceleration, const Motion& motion)
{
    return acceleration / std::max(motion.drag, kLeastWindDrag);
}

/// How far the smoke is expected to rise, m.
float expectedRise(const SampledEffect& effect, float seconds)
{
    const Emitter& emitter = effect->emitter;
    const Motion& motion = effect->motion;
    const float radius = radiusOf(emitter);
    const float buoyancy = std::abs(motion.buoyancy);
    constexpr float kLasting = 2.0F; // heat e^-2 lifts hardly more
    const float lifted = motion.cooling > 0.0F ? std::min(seconds, kLasting / motion.cooling) : seconds;
    if (emitter.mode == EmissionMode::Burst) {
        const float blown = radius * portableExp(std::min(2.0F, effect->air.expansion * emitter.burstDuration / 3.0F));
        const float volume = 4.0F / 3.0F * kPi * blown * blown * blown;
        return 2.0F * blown + 2.4F * portablePow(buoyancy * volume, 0.25F) * std::sqrt(lifted) + emitter.speed * std::min(seconds, 0.5F);
    }
    const float area = kPi * radius * radius;
    const float speed = std::max(emitter.speed, std::sqrt(buoyancy * radius));
    const float plume = 1.9F * portablePow(buoyancy * area * speed, 0.25F) * portablePow(lifted, 0.75F);
    const float jet = 2.5F * portablePow(area, 0.25F) * std::sqrt(emitter.speed * seconds);
    return 2.0F * radius + portablePow(portablePow(plume, 4.0F) + portablePow(jet, 4.0F), 0.25F);
}

/// A box from its lowest to its highest corner, m.
struct Box {
    glm::vec3 low, high;
};

/// What holds all that rises to a height in a wind.
Box fittedBox(const SampledEffect& effect)
{
    const Emitter& emitter = effect->emitter;
    const float seconds = effect->life.initialAlpha / effect->life.fadeRate;
    const float rise = expectedRise(effect, seconds);
    const float radius = radiusOf(emitter);
    constexpr float kWidening = 0.25F;
    constexpr float kRoom = 1.3F;
    const float side = kRoom * radius + kWidening * rise;
    const glm::vec3 up = effect->motion.buoyancy < 0.0F ? glm::vec3(0.0F, -1.0F, 0.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
    // A jet goes where it points, heat goes up.
    const glm::vec3 way = glm::normalize(emitter.normal * (emitter.speed + 0.01F) + up * std::sqrt(std::abs(effect->motion.buoyancy) * rise + 0.01F));
    const float angle = radians(effect->motion.windAngle);
    const glm::vec3 wind = windSpeed(effect->motion.wind * glm::vec3(portableCos(angle), 0.0F, portableSin(angle)), effect->motion);
    constexpr float kBlown = 0.7F; // of its life that smoke is high enough for the wind
    const glm::vec3 end = emitter.position + rise * way + kBlown * seconds * wind;
    Box box{glm::min(emitter.position, end) - side, glm::max(emitter.position, end) + side};
    box.low.y = std::min(emitter.position.y, end.y) - kRoom * radius;
    box.high.y = std::max(emitter.position.y, end.y) + kRoom * radius;
    return box;
}

Box boxOf(const SampledEffect& effect)
{
    const Air& air = effect->air;
    Box box = fittedBox(effect);
    const glm::vec3 foot = effect->emitter.position;
    if (!air.fit) {
        const glm::vec3 centre = foot + air.offset;
        const float below = effect->emitter.shape == EmitterShape::Sphere ? radiusOf(effect->emitter) : 0.0F;
        box.low = {centre.x - 0.5F * air.size.x, centre.y - below, centre.z - 0.5F * air.size.z};
        box.high = box.low + air.size;
    }
    if (air.ground && air.groundHeight < box.high.y) {
        // The floor is the bottom: below it is no air, and between it and the source there is some.
        const bool near = air.groundHeight > box.low.y - 0.5F * (box.high.y - box.low.y);
        if (near) {
            box.low.y = air.groundHeight;
        }
    }
    return box;
}

/// Whether the ground is the lower side of the box.
bool standsOnGround(const SampledEffect& effect, const AirGrid& grid)
{
    return effect->air.ground && std::abs(grid.corner.y - effect->air.groundHeight) < 0.01F * grid.cell;
}

std::vector<Solid> solidsOf(const Air& air)
{
    if (air.obstacle == Obstacle::None) {
        return {};
    }
    return {{air.obstacle == Obstacle::Sphere ? SolidShape::Sphere : SolidShape::Box, air.obstaclePlace, air.obstacleSize}};
}

/// The source, as far as it is the same at every step.
AirSource steadySource(const SampledEffect& effect, const AirGrid& grid)
{
    const Emitter& emitter = effect->emitter;
    AirSource source;
    source.shape = emitter.shape;
    source.place = emitter.position;
    source.normal = glm::normalize(emitter.normal);
    source.basis = planeBasis(source.normal);
    // Less than a cell and a half is less than the grid can show.
    const float least = 1.5F * grid.cell;
    source.reach = glm::max(reachOf(emitter), glm::vec2(least));
    const float radius = std::min(source.reach.x, source.reach.y);
    source.depth = glm::length(sourceDepth(emitter, grid));
    source.softness = std::max(0.4F * radius, 1.5F * grid.cell);
    source.raggedness = effect->air.raggedness;
    source.unevenness = effect->air.unevenness;
    source.speed = emitter.speed;
    source.heat = 1.0F;
    source.expansion = effect->air.expansion;
    const float extent = (1.0F + 3.0F * source.raggedness) * std::max(source.reach.x, source.reach.y) * 1.5F + source.depth + source.softness;
    const auto cellOf = [&](float sign) { return glm::ivec3(glm::floor((source.place - grid.corner + sign * extent) / grid.cell)); };
    source.first = glm::clamp(cellOf(-1.0F), glm::ivec3(0), grid.cells);
    source.last = glm::clamp(cellOf(1.0F) + 1, glm::ivec3(0), grid.cells);
    constexpr int kLanes = static_cast<int>(kAirLanes);
    source.first.x = source.first.x / kLanes * kLanes;
    source.last.x = (source.last.x + kLanes - 1) / kLanes * kLanes;
    return source;
}

/// An octave of noise at a step: two slices of time that cross-fade.
/// @param seed of its own @param frequency 1/m @param rate how often it becomes another, 1/s @param weight of a component's root mean square
AirOctave octaveAt(std::int64_t step, const Schedule& schedule, std::uint32_t seed, float frequency, float rate, float weight)
{
    const RowPosition row = rowPosition(step, schedule, static_cast<double>(rate * schedule.dt));
    const float turn = 0.5F * kPi * row.fraction * row.fraction * (3.0F - 2.0F * row.fraction); // keeps the variance of the sum
    AirOctave octave;
    octave.frequency = frequency;
    octave.shift = {unitFloat(streamBits(seed, 1)), unitFloat(streamBits(seed, 2)), unitFloat(streamBits(seed, 3))};
    octave.slices.key = {keyOf(seed, static_cast<std::uint64_t>(row.before)), keyOf(seed, static_cast<std::uint64_t>(row.after))};
    octave.slices.weight = {weight * portableCos(turn), weight * portableSin(turn)};
    return octave;
}

/// The source's noise at a step.
void moveSource(AirSource& source, const Schedule& schedule, std::uint32_t seed, float rate, std::int64_t step)
{
    const float radius = std::max(source.reach.x, source.reach.y);
    const float square = 1.0F + 0.5F * 0.5F;
    float weight = kCurlNormalisation / std::sqrt(square);
    float frequency = 0.45F / radius;
    float often = rate;
    std::uint32_t stream = kRim;
    for (AirOctave* octave : {&source.rim[0], &source.rim[1], &source.billow}) {
        *octave = octaveAt(step, schedule, streamBits(seed, stream), frequency, often, weight);
        weight *= stream == kRim ? 0.5F : 1.0F; // the smallest is as strong as the one before it: it is what makes billows on billows
        frequency *= 2.0F;
        often *= 1.6F;
        ++stream;
    }
}

/// What stirs the air at a step. Each octave has swirls half as large as the one before and 0.7 of its strength, and becomes another about as often as
/// its swirls turn around.
AirStirring stirringAt(const SampledEffect& effect, const AirGrid& grid, const Schedule& schedule, std::int64_t step)
{
    const Air& air = effect->air;
    constexpr float kRoughness = 0.7F;
    constexpr float kSquares = 1.0F + kRoughness * kRoughness * (1.0F + kRoughness * kRoughness); // of three octaves
    constexpr float kComponents = 3.0F;
    constexpr float kTurns = 0.2F;
    constexpr float kLeastCells = 2.0F; // a smaller swirl is none
    AirStirring stirring;
    stirring.strength = air.turbulence;
    stirring.place = effect->emitter.position;
    stirring.calm = 0.5F * std::max(radiusOf(effect->emitter), grid.cell);
    float size = std::max(air.turbulenceScale, kLeastCells * grid.cell);
    float weight = kCurlNormalisation / std::sqrt(kComponents * kSquares);
    float strength = air.turbulence;
    for (std::uint32_t i = 0; i < kStirringOctaves && size >= kLeastCells * grid.cell; ++i) {
        const std::uint32_t own = streamBits(effect->emitter.seed, kStirring + i);
        stirring.octave[i] = octaveAt(step, schedule, own, 1.0F / size, kTurns * std::sqrt(strength / size), weight);
        stirring.octaves = i + 1;
        size *= 0.5F;
        weight *= kRoughness;
        strength *= kRoughness;
    }
    return stirring;
}

/// The vortex of the effect, about an axis through the emitter. The air takes up its speed while it goes a radius far.
AirSwirl swirlOf(const SampledEffect& effect, float dt)
{
    const Vortex& vortex = effect->vortex;
    const float rate = std::abs(vortex.strength) / vortex.radius;
    return {vortex.strength, vortex.radius, vortex.widening, effect->emitter.position, glm::normalize(vortex.axis), 1.0F - portableExp(-rate * dt)};
}

} // namespace

glm::vec3 sourceDepth(const Emitter& emitter, const AirGrid& grid)
{
    if (emitter.shape == EmitterShape::Sphere) {
        return glm::vec3(0.0F);
    }
    constexpr float kShareOfRadius = 0.4F;
    constexpr float kLeastCells = 1.5F;
    return glm::normalize(emitter.normal) * std::max(kShareOfRadius * radiusOf(emitter), kLeastCells * grid.cell);
}

std::array<glm::vec3, 2> sourceSides(const Emitter& emitter)
{
    const PlaneBasis basis = planeBasis(glm::normalize(emitter.normal));
    constexpr float kLeast = 1e-6F; // m: a point has no sides
    const glm::vec2 reach = glm::max(reachOf(emitter), glm::vec2(kLeast));
    return {basis.across / reach.x, basis.along / reach.y};
}

glm::vec3 sourceVelocity(const Emitter& emitter)
{
    return glm::normalize(emitter.normal) * emitter.speed;
}

AirGrid airGrid(const SampledEffect& effect)
{
    const Box box = boxOf(effect);
    const glm::vec3 size = box.high - box.low;
    const float longest = std::max({size.x, size.y, size.z});
    AirGrid grid;
    grid.cell = longest / static_cast<float>(effect->air.resolution);
    // Rounded to the nearest even number, and the box stays where its middle and its foot are.
    const auto even = [&](float length) { return std::clamp(2 * static_cast<int>(std::lround(0.5F * length / grid.cell)), kMinAirCells, kMaxAirCells); };
    grid.cells = {even(size.x), std::clamp(static_cast<int>(std::lround(size.y / grid.cell)), kMinAirCells, kMaxAirCells), even(size.z)};
    const glm::vec3 whole = grid.size();
    const glm::vec3 middle = 0.5F * (box.low + box.high);
    grid.corner = {middle.x - 0.5F * whole.x, box.low.y, middle.z - 0.5F * whole.z};
    return grid;
}

Status checkAir(const SampledEffect& effect)
{
    if (!effect->air.enabled) {
        return Done{};
    }
    const AirGrid grid = airGrid(effect);
    const glm::vec3 place = effect->emitter.position;
    if (glm::any(glm::lessThan(place, grid.corner - 0.5F * grid.cell)) || glm::any(glm::greaterThan(place, grid.end()))) {
        const bool isBuried = effect->air.ground && place.y < effect->air.groundHeight;
        return isBuried ? Error{ErrorCode::OutOfRange, said("the emitter lies under the ground"), std::string("air"), said("Lower air.ground_height or raise emitter.position")}
                        : Error{ErrorCode::OutOfRange, said("the emitter lies outside the box of the air"), std::string("air"), said("Turn air.fit on, or change air.offset or air.size")};
    }
    const std::vector<Solid> solids = solidsOf(effect->air);
    if (solids.empty() || anyCell(grid.cells, [&](const glm::ivec3& cell) { return !solids.front().contains(grid.centre(cell)); })) {
        return Done{};
    }
    return Error{ErrorCode::OutOfRange, said("the obstacle fills the box of the air"), std::string("air.obstacle_size"), said("Make the obstacle smaller, or move it")};
}

AirStep airStep(const Model& model, const AirGrid& grid, std::int64_t number, bool acts)
{
    const SampledEffect& effect = model.effect();
    const Schedule& schedule = model.schedule();
    const Motion& motion = effect->motion;
    AirStep step;
    step.dt = schedule.dt;
    step.buoyancy = motion.buoyancy;
    step.heatKept = portableExp(-motion.cooling * schedule.dt);
    step.confinement = effect->air.vorticity;
    step.friction = effect->air.friction;
    step.wind = windSpeed(model.windAt(number), motion);
    step.windChange = step.wind - windSpeed(model.windAt(number - 1), motion);
    step.source = steadySource(effect, grid);
    step.source.acts = acts;
    step.source.grip = effect->emitter.speed > 0.0F ? 1.0F - portableExp(-kGrip * schedule.dt) : 0.0F;
    step.swirl = swirlOf(effect, schedule.dt);
    if (effect->air.turbulence > 0.0F) {
        step.stirring = stirringAt(effect, grid, schedule, number);
    }
    if (acts && (step.source.raggedness > 0.0F || step.source.unevenness > 0.0F)) {
        const float radius = std::max(step.source.reach.x, step.source.reach.y);
        const float rate = 0.5F * std::max(effect->emitter.speed, std::sqrt(std::abs(motion.buoyancy) * radius)) / radius;
        moveSource(step.source, schedule, effect->emitter.seed, rate, number);
    }
    return step;
}

AirPlan airPlan(const Model& model)
{
    const SampledEffect& effect = model.effect();
    AirPlan plan;
    plan.grid = airGrid(effect);
    plan.borders.low[1] = standsOnGround(effect, plan.grid) ? Border::Solid : Border::Open;
    plan.solids = solidsOf(effect->air);
    plan.firstStep = model.schedule().firstStep;
    plan.loopSteps = model.schedule().loopSteps;
    plan.wind = windSpeed(model.windAt(0), effect->motion);
    plan.stepTo = [model = Model(effect), grid = plan.grid](std::int64_t number) {
        const Schedule& times = model.schedule();
        return airStep(model, grid, number, (number - 1) % times.periodSteps < times.windowSteps);
    };
    return plan;
}

Effect airPart(const Effect& effect)
{
    Effect part;
    part.air = effect.air;
    part.air.detail = Air().detail;
    part.air.heatOpacity = Air().heatOpacity;
    part.emitter = effect.emitter;
    part.emitter.count = Emitter().count;
    part.emitter.velocityRandomness = Emitter().velocityRandomness;
    part.emitter.spread = Emitter().spread;
    part.emitter.subframe = Emitter().subframe;
    part.motion.wind = effect.motion.wind;
    part.motion.windAngle = effect.motion.windAngle;
    part.motion.gust = effect.motion.gust;
    part.motion.gustRate = effect.motion.gustRate;
    part.motion.drag = effect.motion.drag;
    part.motion.buoyancy = effect.motion.buoyancy;
    part.motion.cooling = effect.motion.cooling;
    part.vortex = effect.vortex;
    part.life.initialAlpha = effect.life.initialAlpha;
    part.life.fadeRate = effect.life.fadeRate;
    part.timeline = effect.timeline;
    if (!effect.timeline.loop) {
        part.timeline.length = Timeline().length;
    }
    return part;
}

} // namespace fumage
