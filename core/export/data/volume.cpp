#include "core/export/data/volume.h"

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/lighting/glow.h"
#include "core/rendering/scene_renderer.h"
#include "core/rendering/sprite_texture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace fumage {

namespace {

/// What a particle leaves in the cells around it.
struct Ball {
    glm::vec3 place; ///< in cells, from the corner of the box
    float radius; ///< in cells
    float crossSection; ///< in squares of a cell
    float heat;
    float glow;
    glm::vec3 velocity;
    std::size_t layer;
};

float glowOf(const GlowColours& colours, float heat, float brightest)
{
    if (!(brightest > 0.0F)) {
        return 0.0F;
    }
    const auto entry = static_cast<std::size_t>(std::clamp(heat, 0.0F, 1.0F) * static_cast<float>(kGlowTableSize - 1));
    return glm::dot(colours[entry], kLuminance) / brightest;
}

float heatOf(const Frame& frame, std::size_t slot, const Effect& effect)
{
    const Particles& particles = frame.particles;
    const float heat = particles.inAir() ? particles.heat[slot] : 1.0F;
    return heat * portableExp(-effect.glow.emissionCooling * lifecycle(frame, slot).age);
}

/// The brightest glow of a layer; 0: it has none.
float brightestOf(const Effect& effect)
{
    float brightest = 0.0F;
    if (effect.glow.emission > 0.0F) {
        for (const glm::vec3& colour : glowColours(effect.glow)) {
            brightest = std::max(brightest, glm::dot(colour, kLuminance));
        }
    }
    return brightest;
}

/// Adds the particles of a layer.
/// @param brightest of all layers
void addBalls(const LayerFrame& layer, std::size_t number, const Appearance& appearance, float brightest,
    const Volume& volume, std::vector<Ball>& balls)
{
    const Frame& frame = *layer.frame;
    const Effect& effect = *layer.effect;
    const bool glows = effect.glow.emission > 0.0F;
    const GlowColours colours = glows ? glowColours(effect.glow) : GlowColours{};
    const float discs = kPi / 3.0F * (appearance.cover.mean / Coverage::kSoftDisc);
    const Particles& p = frame.particles;
    const glm::vec3 corner = volume.corner();
    balls.reserve(balls.size() + appearance.count);
    for (std::size_t i = 0; i < p.capacity; ++i) {
        const float mass = appearance.alpha[i] * appearance.radius[i] * appearance.radius[i]
            * (appearance.left.empty() ? 1.0F : appearance.left[i]);
        if (!(mass > 0.0F)) {
            continue;
        }
        const float heat = heatOf(frame, i, effect);
        balls.push_back({(glm::vec3(p.x[i], p.y[i], p.z[i]) - corner) / volume.cell, appearance.radius[i] / volume.cell,
            mass * discs / (volume.cell * volume.cell), heat, glowOf(colours, heat, brightest),
            {p.vx[i], p.vy[i], p.vz[i]}, number});
    }
}

/// Calls visit(cell, share) for the cells whose centres are in a ball, or the one that it lies in. Shares are not
/// scaled.
template <class Visit>
void forCellsOf(const Ball& ball, const glm::ivec3& cells, const Visit& visit)
{
    const glm::ivec3 most = cells - 1;
    const glm::ivec3 first = glm::clamp(glm::ivec3(glm::ceil(ball.place - ball.radius - 0.5F)), glm::ivec3(0), most);
    const glm::ivec3 last = glm::clamp(glm::ivec3(glm::floor(ball.place + ball.radius - 0.5F)), glm::ivec3(0), most);
    const float scale = 1.0F / (ball.radius * ball.radius);
    bool any = false;
    for (int z = first.z; z <= last.z; ++z) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                const glm::vec3 way = glm::vec3(x, y, z) + 0.5F - ball.place;
                const float inside = 1.0F - glm::dot(way, way) * scale;
                if (inside > 0.0F) {
                    visit(glm::ivec3(x, y, z), inside * inside);
                    any = true;
                }
            }
        }
    }
    if (!any) {
        visit(glm::clamp(glm::ivec3(glm::floor(ball.place)), glm::ivec3(0), most), 1.0F);
    }
}

/// Adds up what balls leave in the planes [begin, end).
void spread(const std::vector<Ball>& balls, const std::vector<float>& sums, Volume& volume, int begin, int end)
{
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const Ball& ball = balls[i];
        constexpr float kSmall = 1.0F; // the one cell of a small ball
        if (ball.place.z + ball.radius + kSmall < static_cast<float>(begin)
            || ball.place.z - ball.radius - kSmall > static_cast<float>(end)) {
            continue;
        }
        const float whole = ball.crossSection / (sums[i] * volume.cell); // cells squared over cells cubed, per metre
        forCellsOf(ball, volume.cells, [&](const glm::ivec3& at, float share) {
            if (at.z < begin || at.z >= end) {
                return;
            }
            const std::size_t cell = static_cast<std::size_t>(at.x)
                + static_cast<std::size_t>(volume.cells.x)
                    * (static_cast<std::size_t>(at.y)
                        + static_cast<std::size_t>(volume.cells.y) * static_cast<std::size_t>(at.z));
            const float density = whole * share;
            volume.density[cell] += density;
            if (!volume.layers.empty()) {
                volume.layers[ball.layer][cell] += density;
            }
            volume.velocity[cell] += density * ball.velocity;
            if (!volume.temperature.empty()) {
                volume.temperature[cell] += density * ball.heat;
            }
            if (!volume.flames.empty()) {
                volume.flames[cell] += density * ball.glow;
            }
        });
    }
}

/// What was summed up over the smoke of a cell becomes its mean, in seconds of the film.
void takeMeans(float timeScale, Volume& volume)
{
    for (std::size_t i = 0; i < volume.density.size(); ++i) {
        if (volume.density[i] > 0.0F) {
            volume.velocity[i] = volume.velocity[i] / volume.density[i] * timeScale;
            if (!volume.temperature.empty()) {
                volume.temperature[i] /= volume.density[i];
            }
        }
    }
}

/// A box around smoke, m.
struct Bounds {
    glm::vec3 low{std::numeric_limits<float>::max()};
    glm::vec3 high{std::numeric_limits<float>::lowest()};

    void add(const Appearance& appearance)
    {
        if (appearance.count > 0) {
            low = glm::min(low, appearance.low - appearance.largestRadius);
            high = glm::max(high, appearance.high + appearance.largestRadius);
        }
    }
    [[nodiscard]] float longestEdge() const
    {
        const glm::vec3 size = high - low;
        return std::max({size.x, size.y, size.z});
    }
};

/// What a box has around the smoke, in all directions: a cell of nothing.
constexpr int kMargin = 1;

/// The box around all balls.
/// @param layers whose densities it has
Status placeBox(int frame, const Bounds& bounds, std::size_t layers, Volume& volume)
{
    const glm::dvec3 low =
        glm::floor(glm::dvec3(bounds.low) / static_cast<double>(volume.cell)) - static_cast<double>(kMargin);
    const glm::dvec3 past =
        glm::floor(glm::dvec3(bounds.high) / static_cast<double>(volume.cell)) + static_cast<double>(kMargin + 1);
    const glm::dvec3 cells = past - low;
    constexpr double kFarthest = 1e9; // on the lattice, that whole numbers count
    const bool isNear = std::max({-low.x, -low.y, -low.z, past.x, past.y, past.z}) <= kFarthest;
    constexpr double kNumbers = 6.0; // of a cell without layers
    const double numbers = layers == 0 ? 0.0 : kNumbers + static_cast<double>(layers);
    const double count = cells.x * cells.y * cells.z;
    if (isNear && count <= static_cast<double>(kMaxVolumeSize)
        && count * numbers > static_cast<double>(kMaxVolumeNumbers)) {
        return Error{ErrorCode::TooLarge,
            makeMessage("the box around the smoke of frame %1 has %2 voxels, too many for %3 layers", frame,
                static_cast<std::int64_t>(count), layers),
            {}, makeMessage("Choose larger voxels, or the density of all layers together")};
    }
    if (!isNear || count > static_cast<double>(kMaxVolumeSize)) {
        return Error{ErrorCode::TooLarge,
            makeMessage("the box around the smoke of frame %1 has more than %2 voxels of %3 m", frame, kMaxVolumeSize,
                formatFloat(volume.cell)),
            {}, makeMessage("Choose larger voxels")};
    }
    volume.first = glm::ivec3(low);
    volume.cells = glm::ivec3(cells);
    return Done{};
}

/// The next number upwards with three digits, more than 0.
double roundedUp(double number)
{
    constexpr double kMin = 100.0; // of three digits
    constexpr double kBase = 10.0;
    double unit = 1.0;
    while (number / unit >= kMin * kBase) {
        unit *= kBase;
    }
    double units = 1.0; // of one below 1: powers of ten are exact, their parts are not
    while (number / unit * units < kMin) {
        units *= kBase;
    }
    return std::ceil(number / unit * units) * unit / units;
}

} // namespace

Result<float> voxelFor(SceneSimulator& simulator, SampledLayers layers, int longest, const Task& task)
{
    Bounds bounds;
    Appearance appearance;
    const int frames = layers.front()->timeline.length;
    for (int number = 0; number < frames; ++number) {
        const Result<SceneFrame> frame = simulator.frame(number, task);
        if (!frame) {
            return frame.error();
        }
        const LayersAtFrame shown(frame.value(), layers);
        for (const LayerFrame& layer : shown.frames()) {
            findAppearance(*layer.frame, *layer.effect, Axes{}, appearance);
            bounds.add(appearance);
        }
        task.progress(ProgressPhase::Fitting, number + 1, frames);
    }
    const float edge = bounds.longestEdge();
    const int inside = longest - 2 * kMargin - 1; // smoke that is n cells long lies in as many as n + 1
    return edge > 0.0F
        ? std::clamp(static_cast<float>(roundedUp(static_cast<double>(edge) / inside)), kMinVoxel, kMaxVoxel)
        : kVoxelWithoutSmoke;
}

Result<Volume> volumeOf(const Frame& frame, const SampledEffect& effect, float voxel)
{
    const Result<GreyCounts> greys = greysShown(effect);
    const LayerFrame layer{&frame, &effect};
    return greys ? volumeOf({&layer, 1}, voxel, {&greys.value(), 1}) : greys.error();
}

VolumeColumns volumeColumns(SampledLayers layers)
{
    VolumeColumns columns;
    for (const SampledEffect& layer : layers) {
        const bool glows = layer.strongest()->glow.emission > 0.0F;
        columns.temperature = columns.temperature || layer->air.enabled || glows;
        columns.flames = columns.flames || glows;
    }
    return columns;
}

Result<Volume> volumeOf(LayerFrames layers, float voxel, std::span<const GreyCounts> greys, LayerDensities densities,
    const VolumeColumns& columns)
{
    std::vector<Appearance> appearances(layers.size());
    Volume volume;
    volume.cell = voxel;
    volume.hasTemperature = columns.temperature;
    volume.hasFlames = columns.flames;
    Bounds bounds;
    float brightest = 0.0F;
    std::size_t count = 0;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const Effect& effect = *layers[i].effect;
        findAppearance(*layers[i].frame, *layers[i].effect, Axes{}, appearances[i], greys[i]);
        bounds.add(appearances[i]);
        count += appearances[i].count;
        const bool glows = effect.glow.emission > 0.0F;
        volume.hasTemperature = volume.hasTemperature || effect.air.enabled || glows;
        volume.hasFlames = volume.hasFlames || glows;
        brightest = std::max(brightest, brightestOf(effect));
    }
    volume.layers.resize(densities == LayerDensities::Yes ? layers.size() : 0);
    if (count == 0) {
        return volume;
    }
    if (Status status = placeBox(layers.front().frame->number, bounds, volume.layers.size(), volume); !status) {
        return status.error();
    }
    const std::size_t cells = static_cast<std::size_t>(volume.cells.x) * static_cast<std::size_t>(volume.cells.y)
        * static_cast<std::size_t>(volume.cells.z);
    volume.density.assign(cells, 0.0F);
    for (std::vector<float>& density : volume.layers) {
        density.assign(cells, 0.0F);
    }
    volume.velocity.assign(cells, glm::vec3(0.0F));
    volume.temperature.assign(volume.hasTemperature ? cells : 0, 0.0F);
    volume.flames.assign(volume.hasFlames ? cells : 0, 0.0F);
    std::vector<Ball> balls;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        addBalls(layers[i], i, appearances[i], brightest, volume, balls);
    }
    std::vector<float> sums(balls.size(), 0.0F);
    parallelFor(balls.size(), [&](std::size_t i) {
        forCellsOf(balls[i], volume.cells, [&](const glm::ivec3& /*at*/, float share) { sums[i] += share; });
    });
    constexpr int kPlanes = 8; // of a task
    parallelFor(static_cast<std::size_t>((volume.cells.z + kPlanes - 1) / kPlanes), [&](std::size_t task) {
        const int begin = static_cast<int>(task) * kPlanes;
        spread(balls, sums, volume, begin, std::min(begin + kPlanes, volume.cells.z));
    });
    takeMeans((*layers.front().effect)->timeline.timeScale, volume);
    return volume;
}

} // namespace fumage
