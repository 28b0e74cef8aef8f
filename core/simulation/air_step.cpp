#include "core/simulation/air_step.h"

#include "core/base/hash.h"
#include "core/base/math.h"
#include "core/base/random_place.h"
#include "core/flow/source_kernel.h"
#include "core/simulation/air_obstacle.h"
#include "core/simulation/air_source.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace fumage {

namespace {

/// Streams of the random numbers of the air.
enum AirStream : std::uint32_t {
    kSurge = 130,
    kRim = 140,
    kForcing = 150
};

/// Drag, 1/s, below which the wind is as fast as if there were this much: without any it would have no speed of its
/// own.
constexpr float kMinWindDrag = 0.5F;

/// How soon the air in the source has the emitter's speed, 1/s.
constexpr float kRelaxation = 30.0F;

/// The source, as far as it is the same at every step.
AirSource steadySource(const SampledEffect& effect, const AirGrid& grid)
{
    const Emitter& emitter = effect->emitter;
    AirSource source;
    source.shape = isRectangular(emitter) ? EmitterShape::Rectangle : emitter.shape;
    source.picture = isOnPicture(emitter) ? emitter.picture : Bitmap();
    source.place = emitter.position;
    source.normal = glm::normalize(emitter.normal);
    source.basis = planeBasis(source.normal);
    // Less than a cell and a half is less than the grid can show.
    const float least = 1.5F * grid.cell;
    source.reach = glm::max(sourceReach(emitter), glm::vec2(least));
    const float radius = std::min(source.reach.x, source.reach.y);
    source.depth = glm::length(sourceDepth(emitter, grid));
    source.softness = std::max(0.4F * radius, 1.5F * grid.cell);
    source.raggedness = effect->source.raggedness;
    source.unevenness = effect->source.unevenness;
    source.speed = emitter.speed * alongNormal(emitter);
    source.heat = 1.0F;
    source.expansion = effect->source.expansion;
    const float extent = (1.0F + 3.0F * source.raggedness) * std::max(source.reach.x, source.reach.y) * 1.5F
        + source.depth + source.softness;
    // Within the box before they are whole numbers: an emitter that a game puts far away lies more cells off than an
    // int holds.
    const auto cellOf = [&](float sign, float more) {
        return glm::ivec3(glm::clamp(glm::floor((source.place - grid.corner + sign * extent) / grid.cell) + more,
            glm::vec3(0.0F), glm::vec3(grid.cells)));
    };
    source.first = cellOf(-1.0F, 0.0F);
    source.last = cellOf(1.0F, 1.0F);
    constexpr int kLanes = static_cast<int>(kAirLanes);
    source.first.x = source.first.x / kLanes * kLanes;
    source.last.x = (source.last.x + kLanes - 1) / kLanes * kLanes;
    return source;
}

/// An octave of noise at a step: two slices of time that cross-fade.
/// @param seed of its own @param frequency 1/m @param rate how often it becomes another, 1/s @param weight of a
/// component's root mean square
AirOctave octaveAt(double step, const Schedule& schedule, std::uint32_t seed, float frequency, float rate, float weight)
{
    const RowPosition row = rowPosition(step, schedule, static_cast<double>(rate * schedule.dt));
    // keeps the variance of the sum
    const float turn = 0.5F * kPi * row.fraction * row.fraction * (3.0F - 2.0F * row.fraction);
    AirOctave octave;
    octave.frequency = frequency;
    octave.shift = randomInUnitCube(seed, 1);
    octave.slices.key = {
        keyOf(seed, static_cast<std::uint64_t>(row.before)), keyOf(seed, static_cast<std::uint64_t>(row.after))};
    octave.slices.weight = {weight * portableCos(turn), weight * portableSin(turn)};
    return octave;
}

/// Mean of max(0, 1 + deviation n), n normally distributed: what unevenness makes of the heat of all sources together.
float meanOfUneven(float deviation)
{
    constexpr float kFarthest = 6.0F; // in deviations: beyond it nothing is cut off
    const float x = std::min(kFarthest, 1.0F / deviation);
    const float below = 1.0F / (1.0F + portableExp(-x * (1.5976F + 0.070565F * x * x))); // Page 1977; 2e-4 off at most
    constexpr float kPeak = 0.39894228F; // 1 / sqrt(2 pi)
    return below + deviation * kPeak * portableExp(-0.5F * x * x);
}

/// Makes the mean heat of a source that of all such sources: its largest swirls are larger than itself, and one would
/// else be twice as hot as another.
void evenOut(AirSource& source)
{
    constexpr float kThirdOctave = 1.2F; // its square comes on top of the two others', which are 1
    constexpr float kMin = 0.25F; // a source that is all but cold is not made hot
    const float usual = meanOfUneven(source.unevenness * std::sqrt(kThirdOctave));
    source.heat *= usual / std::max(kMin, meanUnevenness(source));
}

/// The source's noise at a step.
void moveSource(AirSource& source, const Schedule& schedule, std::uint32_t seed, float rate, double step)
{
    const float radius = std::max(source.reach.x, source.reach.y);
    const float square = 1.0F + 0.5F * 0.5F;
    float weight = kCurlNormalisation / std::sqrt(square);
    float frequency = 0.45F / radius;
    float often = rate;
    std::uint32_t stream = kRim;
    for (AirOctave* octave : {&source.rim[0], &source.rim[1], &source.billow}) {
        *octave = octaveAt(step, schedule, streamBits(seed, stream), frequency, often, weight);
        weight *= stream == kRim
            ? 0.5F
            : 1.0F; // the smallest is as strong as the one before it: it is what makes billows on billows
        frequency *= 2.0F;
        often *= 1.6F;
        ++stream;
    }
    if (source.unevenness > 0.0F) {
        evenOut(source);
    }
}

/// How strong a source that surges is at a step, 1 in the mean: in each puff it swells soon and falls slowly, as
/// 27/4 f (1 - f)^2 of the share f of the puff that has passed, and each is as strong as chance has it.
float surgeAt(const SimulationModel& model, const SampledEffect& effect, double step)
{
    constexpr float kPeak = 27.0F / 4.0F; // f (1 - f)^2 is 4/27 at most
    constexpr float kMean = kPeak / 12.0F;
    constexpr float kChance = 0.4F;
    const RowPosition puff = model.surgeAt(step);
    const std::uint32_t key = keyOf(streamBits(effect->emitter.seed, kSurge), static_cast<std::uint64_t>(puff.before));
    const float f = puff.fraction;
    const float swell = (1.0F + kChance * signedFloat(key)) * kPeak * f * (1.0F - f) * (1.0F - f);
    return 1.0F + effect->source.surge * (swell - kMean);
}

/// A burst has one surge, which is itself.
bool surges(const SampledEffect& effect)
{
    return effect->source.surge > 0.0F && effect->emitter.mode != EmissionMode::Burst;
}

/// What stirs the air at a step. Each octave has swirls half as large as the one before and 0.7 of its strength, and
/// becomes another about as often as its swirls turn around.
/// @param effect at the step
TurbulenceForcing forcingAt(const SimulationModel& model, const SampledEffect& effect, const AirGrid& grid, double step)
{
    const Air& air = effect->air;
    const Air& strongest = model.strongest()->air;
    constexpr float kRoughness = 0.7F;
    constexpr float kSquares = 1.0F + kRoughness * kRoughness * (1.0F + kRoughness * kRoughness); // of three octaves
    constexpr float kComponents = 3.0F;
    constexpr float kTurns = 0.2F;
    constexpr float kMinCells = 2.0F; // a smaller swirl is none
    TurbulenceForcing forcing;
    forcing.strength = air.turbulence;
    forcing.place = effect->emitter.position;
    forcing.calm = 0.5F * std::max(sourceRadius(effect->emitter), grid.cell);
    float size = std::max(air.turbulenceScale, kMinCells * grid.cell);
    float weight = kCurlNormalisation / std::sqrt(kComponents * kSquares);
    float rated = std::max(strongest.turbulenceScale, kMinCells * grid.cell);
    float strength = strongest.turbulence;
    for (std::uint32_t i = 0; i < kForcingOctaves && size >= kMinCells * grid.cell; ++i) {
        const std::uint32_t own = streamBits(effect->emitter.seed, kForcing + i);
        const float often = kTurns * std::sqrt(strength / rated);
        forcing.octave[i] = octaveAt(step, model.schedule(), own, 1.0F / size, often, weight);
        forcing.octaves = i + 1;
        size *= 0.5F;
        rated *= 0.5F;
        weight *= kRoughness;
        strength *= kRoughness;
    }
    return forcing;
}

/// The vortex of the effect, about an axis through the emitter. The air takes up its speed while it goes a radius far.
AirVortex vortexOf(const SampledEffect& effect, float dt)
{
    const Vortex& vortex = effect->vortex;
    const float rate = std::abs(vortex.strength) / vortex.radius;
    return {vortex.strength, vortex.radius, vortex.widening, effect->emitter.position, glm::normalize(vortex.axis),
        1.0F - portableExp(-rate * dt)};
}

/// Longest that air is followed at once, s: over more of it heat goes on rising straight where it would have turned,
/// and smoke gets too high.
constexpr float kLongestPiece = 1.0F / 24.0F;

/// Most that the source adds to the air in a piece, of its own volume: air is traced back along straight ways, which a
/// source that blows up bends.
constexpr float kMaxGrowth = 0.6F;

/// Most parts that are kept for the particles, which go through more pieces than that by several at once.
constexpr int kMaxParts = 8;

/// A part of a step.
struct Moment {
    double start = 0.0; ///< of the stretch in which the same sources act, in steps from the step before
    double begin = 0.0; ///< since then
    double end = 0.0;
    float share = 1.0F; ///< end - begin
    float actsBeyond = 0.0F; ///< what acts for longer than this acts in it

    /// When it begins and ends, in steps of a layer.
    [[nodiscard]] double beginAfter(std::int64_t step) const { return static_cast<double>(step) + start + begin; }
    [[nodiscard]] double endAfter(std::int64_t step) const { return static_cast<double>(step) + start + end; }
};

/// Parts of a span of time that are all alike.
struct Division {
    int parts = 1;
    int pieces = 1; ///< of each
};

/// What a source that acts adds to the air, of its own volume, 1/s at most.
float mostGrowth(const SampledEffect& effect)
{
    return effect->source.expansion * (1.0F + (surges(effect) ? effect->source.surge : 0.0F));
}

/// @param growth of the strongest source that acts, 1/s
Division divisionOf(float seconds, float growth)
{
    constexpr float kRounding = 1e-4F;
    const float least = std::ceil(std::max(seconds / kLongestPiece, growth * seconds / kMaxGrowth) - kRounding);
    const int pieces = std::max(1, static_cast<int>(least));
    const int parts = std::min(pieces, kMaxParts);
    return {parts, (pieces + parts - 1) / parts};
}

/// Calls visit(moment, pieces) for the parts of a step in their order: between two of them a source may stop.
template <class Visit>
void forParts(std::span<const AirFeeder> feeders, const Visit& visit)
{
    float begin = 0.0F;
    while (begin < 1.0F) {
        float end = 1.0F; // where the next of them stops
        for (const AirFeeder& feeder : feeders) {
            end = feeder.acts > begin ? std::min(end, feeder.acts) : end;
        }
        const auto span = static_cast<float>(static_cast<double>(end) - static_cast<double>(begin));
        float growth = 0.0F;
        for (const AirFeeder& feeder : feeders) {
            std::optional<SampledEffect> room;
            const SampledEffect& effect = feeder.model->effectAt(static_cast<double>(feeder.number), room);
            growth = std::max(growth, feeder.acts > begin ? mostGrowth(effect) : 0.0F);
        }
        const Division division = divisionOf(span * feeders.front().model->schedule().dt, growth);
        for (int i = 0; i < division.parts; ++i) {
            const auto at = [&](int part) {
                return (static_cast<double>(end) - static_cast<double>(begin)) * part / division.parts;
            };
            visit(
                Moment{static_cast<double>(begin), at(i), at(i + 1), span / static_cast<float>(division.parts), begin},
                division.pieces);
        }
        begin = end;
    }
}

/// How far a source reaches from its middle, m: at least as far as the grid can show.
float reachOf(const Emitter& emitter, const AirGrid& grid)
{
    const glm::vec2 reach = sourceReach(emitter);
    return std::max({reach.x, reach.y, 1.5F * grid.cell});
}

/// What an emitter does to the air in a part of a step.
/// @param dt of a piece
AirFeed feedOf(const AirFeeder& feeder, const AirGrid& grid, const Moment& moment, float dt)
{
    const SimulationModel& model = *feeder.model;
    const double begin = moment.beginAfter(feeder.number - 1);
    const double end = moment.endAfter(feeder.number - 1);
    std::optional<SampledEffect> room;
    const SampledEffect& effect = model.effectAt(end, room);
    AirFeed feed;
    AirSource& source = feed.source;
    source = steadySource(effect, grid);
    source.acts = feeder.acts > moment.actsBeyond && effect->emitter.rate > 0.0F;
    source.heat *= effect->emitter.rate;
    source.expansion *= effect->emitter.rate;
    source.relaxation =
        effect->emitter.speed > 0.0F ? 1.0F - portableExp(-kRelaxation * alongNormal(effect->emitter) * dt) : 0.0F;
    feed.vortex = vortexOf(effect, dt);
    if (source.acts && (source.raggedness > 0.0F || source.unevenness > 0.0F)) {
        const Effect& often = model.strongest();
        const float radius = reachOf(often.emitter, grid);
        const float rate =
            0.5F * std::max(often.emitter.speed, std::sqrt(std::abs(often.air.buoyancy) * radius)) / radius;
        moveSource(source, model.schedule(), effect->emitter.seed, rate, end);
    }
    if (source.acts && surges(effect)) {
        const float strength = surgeAt(model, effect, 0.5 * (begin + end));
        source.heat *= strength;
        source.speed *= strength;
        source.expansion *= strength;
    }
    return feed;
}

void findAirPart(
    std::span<const AirFeeder> feeders, const AirGrid& grid, const Moment& moment, int pieces, AirStep& step)
{
    const SimulationModel& model = *feeders.front().model;
    const double begin = moment.beginAfter(feeders.front().number - 1);
    const double end = moment.endAfter(feeders.front().number - 1);
    std::optional<SampledEffect> room;
    const SampledEffect& effect = model.effectAt(end, room);
    const Air& air = effect->air;
    std::optional<SampledEffect> roomBefore;
    const Air& airBefore = model.effectAt(begin, roomBefore)->air;
    step.share = moment.share;
    step.pieces = pieces;
    step.dt = model.schedule().dt * moment.share / static_cast<float>(pieces);
    step.buoyancy = air.buoyancy;
    step.heatKept = portableExp(-air.cooling * step.dt);
    step.confinement = air.vorticity;
    step.friction = air.friction;
    step.wind = windSpeed(model.windAt(end), air);
    step.windChange = (step.wind - windSpeed(model.windAt(begin), airBefore)) / static_cast<float>(pieces);
    step.forcing = air.turbulence > 0.0F ? forcingAt(model, effect, grid, end) : TurbulenceForcing();
    step.obstacle = obstacleIn(model, begin, end, model.schedule().dt * moment.share, airBefore, air);
    step.others.clear();
    for (const AirFeeder& feeder : feeders) {
        AirFeed feed = feedOf(feeder, grid, moment, step.dt);
        if (&feeder == &feeders.front()) {
            step.source = feed.source;
            step.vortex = feed.vortex;
        } else {
            step.others.push_back(std::move(feed));
        }
    }
}

} // namespace

glm::vec3 windSpeed(const glm::vec3& acceleration, const Air& air)
{
    return acceleration / std::max(air.drag, kMinWindDrag);
}

int piecesOfStep(const SampledEffect& effect, float seconds, bool acts)
{
    const Division division = divisionOf(seconds, acts ? mostGrowth(effect) : 0.0F);
    return division.parts * division.pieces;
}

std::size_t usualParts(std::span<const AirFeeder> feeders)
{
    constexpr double kFewSteps = 64.0;
    std::vector<AirFeeder> usual(feeders.begin(), feeders.end());
    for (AirFeeder& feeder : usual) {
        feeder.acts = feeder.model->schedule().emittingSteps > kFewSteps ? 1.0F : 0.0F;
    }
    int parts = 0;
    forParts(usual, [&](const Moment& /*moment*/, int /*pieces*/) { ++parts; });
    return static_cast<std::size_t>(parts);
}

void findAirStep(std::span<const AirFeeder> feeders, const AirGrid& grid, AirStep& out)
{
    std::size_t parts = 0;
    forParts(feeders, [&](const Moment& /*moment*/, int /*pieces*/) { ++parts; });
    out.earlier.resize(parts - 1);
    std::size_t part = 0;
    forParts(feeders, [&](const Moment& moment, int pieces) {
        findAirPart(feeders, grid, moment, pieces, part + 1 == parts ? out : out.earlier[part]);
        ++part;
    });
}

AirStep airStep(std::span<const AirFeeder> feeders, const AirGrid& grid)
{
    AirStep out;
    findAirStep(feeders, grid, out);
    return out;
}

AirStep airStep(const SimulationModel& model, const AirGrid& grid, std::int64_t number, float acts)
{
    const AirFeeder feeder{&model, number, acts};
    return airStep({&feeder, 1}, grid);
}

} // namespace fumage
