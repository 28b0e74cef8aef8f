#include "core/simulation/air_plan.h"

#include "core/base/hash.h"
#include "core/base/math.h"
#include "core/base/vector.h"
#include "core/effect/known_parameter.h"
#include "core/effect/parameter_table.h"
#include "core/simulation/air_obstacle.h"
#include "core/simulation/simulation_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace fumage {

namespace {

/// The least radius of a source that a box is made for, m: about that of a wick. A point in still air would else have a
/// box without extent.
constexpr float kMinRadius = 0.005F;

/// How far the smoke is expected to rise, m.
float expectedRise(const SampledEffect& effect, float seconds)
{
    const Emitter& emitter = effect->emitter;
    const Air& air = effect->air;
    const float radius = std::max(kMinRadius, sourceRadius(emitter));
    const float buoyancy = std::abs(air.buoyancy);
    constexpr float kLasting = 2.0F; // heat e^-2 lifts hardly more
    const float lifted = air.cooling > 0.0F ? std::min(seconds, kLasting / air.cooling) : seconds;
    if (emitter.mode == EmissionMode::Burst) {
        const float blown =
            radius * portableExp(std::min(2.0F, effect->source.expansion * emitter.burstDuration / 3.0F));
        const float volume = 4.0F / 3.0F * kPi * blown * blown * blown;
        return 2.0F * blown + 2.4F * portablePow(buoyancy * volume, 0.25F) * std::sqrt(lifted)
            + emitter.speed * std::min(seconds, 0.5F);
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
    const float radius = std::max(kMinRadius, sourceRadius(emitter));
    constexpr float kWidening = 0.25F;
    constexpr float kRoom = 1.3F;
    const float side = kRoom * radius + kWidening * rise;
    const glm::vec3 up = effect->air.buoyancy < 0.0F ? glm::vec3(0.0F, -1.0F, 0.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
    // A jet goes where it points, heat goes up.
    const glm::vec3 both =
        emitter.normal * (emitter.speed + 0.01F) + up * std::sqrt(std::abs(effect->air.buoyancy) * rise + 0.01F);
    constexpr float kNoWay = 1e-3F; // m/s: they cancel
    const glm::vec3 way = glm::length(both) > kNoWay ? glm::normalize(both) : up;
    const glm::vec3 wind = windSpeed(effect->wind.strength * horizontalDirection(effect->wind.angle), effect->air);
    constexpr float kBlown = 0.7F; // of its life that smoke is high enough for the wind
    const glm::vec3 end = emitter.position + rise * way + kBlown * seconds * wind;
    Box box{glm::min(emitter.position, end) - side, glm::max(emitter.position, end) + side};
    box.low.y = std::min(emitter.position.y, end.y) - kRoom * radius;
    box.high.y = std::max(emitter.position.y, end.y) + kRoom * radius;
    return box;
}

/// Times at which a box looks at an effect, s: at its keys, and between them where it may swing out.
std::vector<double> timesOf(const SampledEffect& effect)
{
    std::vector<double> times{0.0};
    constexpr std::size_t kMaxTimes = 256;
    constexpr int kBetween = 4;
    for (const Track& track : effect.allTracks()) {
        const std::size_t stride = 1 + kBetween * track.keys.size() / kMaxTimes;
        for (std::size_t key = 0; track.parameter->dirties == DirtyStage::Air && key < track.keys.size();
             key += stride) {
            const double from = track.keys[key].seconds;
            const double to = track.keys[std::min(key + stride, track.keys.size() - 1)].seconds;
            for (int part = 0; part < kBetween; ++part) {
                times.push_back(std::max(0.0, from + (to - from) * part / kBetween));
            }
        }
    }
    return times;
}

/// What holds an effect at all times.
Box boxOverTime(const SampledEffect& effect)
{
    Box box = fittedBox(effect.atTime(0.0));
    if (effect.tracks()) {
        for (const double seconds : timesOf(effect)) {
            const Box then = fittedBox(effect.atTime(seconds));
            box = {glm::min(box.low, then.low), glm::max(box.high, then.high)};
        }
    }
    return box;
}

std::vector<std::size_t> feedingLayers(SampledLayers layers)
{
    std::vector<std::size_t> out;
    findFeedingLayers(layers, out);
    return out;
}

Box boxOf(SampledLayers layers)
{
    const std::vector<std::size_t> feeding = feedingLayers(layers);
    const SampledEffect first = layers[feeding.front()].atTime(0.0);
    const Air& air = first->air;
    Box box = boxOverTime(layers[feeding.front()]);
    for (const std::size_t layer : feeding) {
        const Box other = boxOverTime(layers[layer]);
        box = {glm::min(box.low, other.low), glm::max(box.high, other.high)};
    }
    const glm::vec3 foot = first->emitter.position;
    if (!air.fit) {
        const glm::vec3 centre = foot + air.offset;
        const float below = first->emitter.shape == EmitterShape::Sphere ? sourceRadius(first->emitter) : 0.0F;
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
bool standsOnGround(const Air& air, const AirGrid& grid)
{
    return air.ground && std::abs(grid.corner.y - air.groundHeight) < 0.01F * grid.cell;
}

/// Whether what stands in the air leaves any of it.
bool leavesAir(const Air& air, const AirGrid& grid)
{
    const std::optional<Solid> obstacle = obstacleOf(air);
    return !obstacle
        || anyCell(grid.cells, [&](const glm::ivec3& cell) { return !obstacle->contains(grid.centre(cell)); });
}

/// The same at all times.
bool alwaysLeavesAir(const SampledEffect& effect, const AirGrid& grid)
{
    if (!effect.changes(knownParameter("air.obstacle_position"))
        && !effect.changes(knownParameter("air.obstacle_size"))) {
        return leavesAir(effect->air, grid);
    }
    const std::vector<double> times = timesOf(effect);
    return std::all_of(
        times.begin(), times.end(), [&](double seconds) { return leavesAir(effect.atTime(seconds)->air, grid); });
}

/// Most cells that may have to be stepped before a first picture: about five minutes of one processor. The longest loop
/// of the built-in presets takes a twentieth.
constexpr double kMaxWork = 1e10;

/// Cells that are stepped before the first picture is there: of a loop, all of it and the half into which it goes over.
double workBeforeFirstFrame(SampledLayers layers, const AirGrid& grid)
{
    const Schedule schedule = makeSchedule(layers.front());
    const double cells = static_cast<double>(grid.cells.x) * grid.cells.y * grid.cells.z;
    const double steps = static_cast<double>(firstAirStep(layers)) + 1.5 * static_cast<double>(schedule.loopSteps);
    int pieces = 1;
    for (const std::size_t layer : feedingLayers(layers)) {
        const bool acts = layers[layer]->emitter.mode == EmissionMode::Continuous;
        pieces = std::max(pieces, piecesOfStep(layers[layer].strongest(), schedule.dt, acts));
    }
    return steps * pieces * cells;
}

/// Whether an emitter lies where there is air.
Status checkEmitter(const SampledEffect& effect, const AirGrid& grid)
{
    const glm::vec3 place = effect->emitter.position;
    if (!glm::any(glm::lessThan(place, grid.corner - 0.5F * grid.cell))
        && !glm::any(glm::greaterThan(place, grid.end()))) {
        return Done{};
    }
    const bool isBuried = effect->air.ground && place.y < effect->air.groundHeight;
    return isBuried ? Error{ErrorCode::OutOfRange, makeMessage("the emitter lies under the ground"), std::string("air"),
               makeMessage("Lower air.ground_height or raise emitter.position")}
                    : Error{ErrorCode::OutOfRange, makeMessage("the emitter lies outside the box of the air"),
                        std::string("air"), makeMessage("Turn air.fit on, or change air.offset or air.size")};
}

/// A model that feeds the air, with the clock that says which of its steps is one of the air.
AirFeeder feederAt(const SimulationModel& model, std::int64_t airStep)
{
    const Schedule& schedule = model.schedule();
    AirFeeder feeder{&model, airStep - model.clock().stepsBehind, 0.0F};
    if (schedule.loopSteps > 0 && feeder.number < 1) {
        feeder.number += (schedule.loopSteps - feeder.number) / schedule.loopSteps * schedule.loopSteps;
    }
    const bool isBorn = feeder.number >= 1;
    feeder.acts = isBorn && model.effect()->source.feeds ? schedule.actsAfter(feeder.number - 1) : 0.0F;
    return feeder;
}

std::vector<AirFeeder> feedersAt(const std::vector<SimulationModel>& models, std::int64_t airStep)
{
    std::vector<AirFeeder> feeders;
    for (const SimulationModel& model : models) {
        feeders.push_back(feederAt(model, airStep));
    }
    return feeders;
}

} // namespace

void findFeedingLayers(SampledLayers layers, std::vector<std::size_t>& out)
{
    out.resize(layers.size());
    std::iota(out.begin(), out.end(), std::size_t{0});
    const auto gives = [&](std::size_t layer) { return layers[layer]->source.feeds; };
    std::sort(out.begin(), out.end(), [&](std::size_t a, std::size_t b) {
        return std::tuple(!gives(a), layers[a]->emitter.seed, a) < std::tuple(!gives(b), layers[b]->emitter.seed, b);
    });
    const auto count = static_cast<std::size_t>(std::count_if(out.begin(), out.end(), gives));
    out.resize(std::max<std::size_t>(1, count));
}

AirGrid airGrid(SampledLayers layers)
{
    const Box box = boxOf(layers);
    const glm::vec3 size = box.high - box.low;
    const float longest = std::max({size.x, size.y, size.z});
    // Far from the origin floats are too coarse to tell smaller cells apart.
    const glm::vec3 farthest = glm::max(glm::abs(box.low), glm::abs(box.high));
    constexpr float kFinest = 0x1p-20F;
    AirGrid grid;
    grid.cell = std::max(longest / static_cast<float>(layers.front()->air.resolution),
        kFinest * std::max({farthest.x, farthest.y, farthest.z}));
    // Rounded to the nearest even number, and the box stays where its middle and its foot are.
    const auto even = [&](float length) {
        return std::clamp(2 * static_cast<int>(std::lround(0.5F * length / grid.cell)), kMinAirCells, kMaxAirCells);
    };
    grid.cells = {even(size.x),
        std::clamp(static_cast<int>(std::lround(size.y / grid.cell)), kMinAirCells, kMaxAirCells), even(size.z)};
    const glm::vec3 whole = grid.size();
    const glm::vec3 middle = 0.5F * (box.low + box.high);
    grid.corner = {middle.x - 0.5F * whole.x, box.low.y, middle.z - 0.5F * whole.z};
    return grid;
}

Status checkAir(SampledLayers layers)
{
    const SampledEffect& effect = layers.front();
    if (!effect->air.enabled) {
        return Done{};
    }
    const AirGrid grid = airGrid(layers);
    if (!std::isfinite(grid.size().x + grid.size().y + grid.size().z)) {
        return Error{ErrorCode::OutOfRange, makeMessage("the box of the air has no finite size"), std::string("air"),
            makeMessage("Turn air.fit off and give air.size, or make the emitter smaller or slower")};
    }
    for (const std::size_t layer : feedingLayers(layers)) {
        if (Status status = checkEmitter(layers[layer].atTime(0.0), grid); !status) {
            return status;
        }
    }
    if (workBeforeFirstFrame(layers, grid) > kMaxWork) {
        return effect->timeline.loop
            ? Error{ErrorCode::TooLarge,
                makeMessage("the air of a loop of %1 frames is baked whole before its first picture, which would take "
                            "very long",
                    effect->timeline.length),
                std::string("timeline.length"),
                makeMessage("Shorten timeline.length, lower air.resolution, or turn timeline.loop off")}
            : Error{ErrorCode::TooLarge,
                makeMessage("the air has to be moved on for a whole life of the smoke before its first picture, which "
                            "would take very long"),
                std::string("timeline.prewarm"),
                makeMessage("Turn timeline.prewarm off, raise life.fade_rate, or lower air.resolution")};
    }
    if (alwaysLeavesAir(effect, grid)) {
        return Done{};
    }
    return Error{ErrorCode::OutOfRange, makeMessage("the obstacle fills the box of the air"),
        std::string("air.obstacle_size"), makeMessage("Make the obstacle smaller, or move it")};
}

std::int64_t firstAirStep(SampledLayers layers)
{
    std::int64_t first = std::numeric_limits<std::int64_t>::min();
    for (const std::size_t layer : feedingLayers(layers)) {
        first = std::max(first, makeSchedule(layers[layer]).firstStep);
    }
    return std::max<std::int64_t>(0, first);
}

LayerClock layerClock(SampledLayers layers, const SampledEffect& layer)
{
    return {firstAirStep(layers) - makeSchedule(layer).firstStep, layers[feedingLayers(layers).front()]->emitter.seed};
}

AirPlan airPlan(SampledLayers layers)
{
    const Air& air = layers.front()->air;
    std::vector<SimulationModel> models;
    for (const std::size_t layer : feedingLayers(layers)) {
        models.emplace_back(layers[layer], layerClock(layers, layers[layer]));
    }
    AirPlan plan;
    plan.grid = airGrid(layers);
    plan.boundaries.low[1] = standsOnGround(air, plan.grid) ? Boundary::Solid : Boundary::Open;
    plan.firstStep = firstAirStep(layers);
    plan.loopSteps = models.front().schedule().loopSteps;
    plan.parts = usualParts(feedersAt(models, 1));
    const auto start = static_cast<double>(-models.front().clock().stepsBehind);
    std::optional<SampledEffect> room;
    const Air& atStart = models.front().effectAt(start, room)->air;
    plan.wind = windSpeed(models.front().windAt(start), atStart);
    if (const std::optional<Solid> obstacle = obstacleOf(atStart)) {
        plan.solids = {*obstacle};
    }
    plan.stepTo = [models = std::move(models), grid = plan.grid](
                      std::int64_t number) { return airStep(feedersAt(models, number), grid); };
    return plan;
}

namespace {

/// Whether the air is another one where the timeline is longer. What does not loop goes on for ever, and its length is
/// that of the pictures; but rates whose keys repeat are summed up as far as it goes.
bool lengthMatters(const SampledEffect& effect)
{
    const std::span<const Track> tracks = effect.allTracks();
    return effect->timeline.loop || std::any_of(tracks.begin(), tracks.end(), [](const Track& track) {
        return track.parameter->animates == Animates::Rate && track.parameter->dirties == DirtyStage::Air
            && track.after != Extrapolation::Hold;
    });
}

} // namespace

std::vector<AirPart> airParts(SampledLayers layers)
{
    std::vector<AirPart> parts;
    for (const std::size_t layer : feedingLayers(layers)) {
        AirPart& part = parts.emplace_back();
        for (const Parameter& parameter : parameterTable()) {
            if (parameter.dirties == DirtyStage::Air
                && (lengthMatters(layers[layer]) || &parameter != &knownParameter("timeline.length"))) {
                parameter.set(part.effect, parameter.get(layers[layer]));
            }
        }
        for (const Track& track : layers[layer].allTracks()) {
            if (track.parameter->dirties == DirtyStage::Air) {
                part.tracks.set(track);
            }
        }
    }
    return parts;
}

} // namespace fumage
