#include "core/lighting/light_grid.h"

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/base/vector.h"
#include "core/lighting/detail_light.h"
#include "core/lighting/light_kernel.h"
#include "core/lighting/multiple_scattering.h"
#include "core/scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fumage {

Axes lightAxes(const glm::vec3& direction)
{
    const PlaneBasis plane = planeBasis(direction);
    return {plane.across, plane.along, direction};
}

namespace {

constexpr std::size_t kPadding = kAlignment / sizeof(float);

/// Whether anything that is seen depends on the density.
bool needsDensity(LitLayers layers, const Light& light)
{
    const bool shadows = light.intensity > 0.0F && light.shadow > 0.0F;
    return shadows || std::any_of(layers.begin(), layers.end(), [&](const LitLayer& layer) {
        const Effect& effect = *layer.effect;
        const bool glowsByOpenness = effect.glow.emission > 0.0F && effect.glow.hotCore > 0.0F;
        const bool occludes = light.occlusion > 0.0F && (light.ambient > 0.0F || glowsByOpenness);
        return occludes || effect.look.overlap > 1.0F || hasDetail(effect);
    });
}

/// The most cells that the longest edge of the cloud is worth.
int finestResolution(const Light& light, bool dense)
{
    if (dense) {
        return light.resolution;
    }
    // The scattering of clear air changes with the angle between sun and eye alone: smoothly, or not at all.
    constexpr int kOfAngles = 16;
    return light.intensity > 0.0F && light.anisotropy != 0.0F ? std::min(light.resolution, kOfAngles) : 1;
}

/// The smallest edge of a cell that shadows are worth. In finer ones particles would shadow themselves more than one
/// another, so that the same smoke cut into fewer particles would look darker; and few particles need few cells.
float smallestCell(const LitBounds& bounds, const Light& light)
{
    constexpr float kCellsAParticle = 16.0F;
    constexpr float kThird = 1.0F / 3.0F;
    constexpr float kNoVolume = 1e-30F;
    const glm::vec3 extent = bounds.high - bounds.low;
    const float volume = std::max(kNoVolume, extent.x * extent.y * extent.z);
    const float filled = portablePow(volume / (kCellsAParticle * static_cast<float>(bounds.count)), kThird);
    constexpr float kTypical = 0.4F; // a particle's mass over the largest; of the built-in presets 0.32 to 0.58
    constexpr float kMaxOwnDepth = 0.3F; // optical depth of one particle spread over a cell
    const float crossSection =
        kTypical * kPi * bounds.cover * bounds.largestMass * std::max(light.shadow, light.occlusion);
    return std::max(filled, std::sqrt(crossSection / kMaxOwnDepth));
}

GridShape gridShape(const LitBounds& bounds, const Light& light, const Axes& axes, int resolution)
{
    GridShape shape;
    shape.axes = axes;
    if (resolution == 1) {
        return shape;
    }
    constexpr float kSmallestCloud = 1e-3F;
    const glm::vec3 extent = bounds.high - bounds.low;
    const float longest = std::max({extent.x, extent.y, extent.z, kSmallestCloud});
    constexpr float kMinCells = 6.0F; // along the longest edge: less shows no shadow
    shape.finest = longest / static_cast<float>(resolution - 2);
    shape.cell = std::max(shape.finest, std::min(longest / kMinCells, smallestCell(bounds, light)));
    shape.origin = bounds.low - glm::vec3(0.5F * shape.cell);
    // One cell of air on every side, so that bounds never cut a particle in half.
    const auto count = [&](float length) {
        return static_cast<int>(std::min(static_cast<float>(resolution), std::ceil(length / shape.cell) + 2.0F));
    };
    shape.nu = count(extent.x);
    shape.nv = count(extent.y);
    shape.nw = count(extent.z);
    return shape;
}

std::array<AmbientDirection, 6> ambientDirections(const Axes& axes)
{
    std::array<AmbientDirection, 6> out;
    const std::array<float, 3> ups{axes.u.y, axes.v.y, axes.w.y};
    for (std::size_t i = 0; i < out.size(); ++i) {
        AmbientDirection& direction = out[i];
        direction.axis = static_cast<int>(i / 2);
        direction.reversed = i % 2 == 1;
        // Light that travels along +axis comes from -axis.
        const float fromAbove = direction.reversed ? ups[i / 2] : -ups[i / 2];
        constexpr float kSumOfWeights = 3.0F;
        direction.sky = 0.5F * (1.0F + fromAbove) / kSumOfWeights;
        direction.ground = 0.5F * (1.0F - fromAbove) / kSumOfWeights;
    }
    return out;
}

void addAmbientLight(const Light& light, LightWorkspace& room, LightGrid& out)
{
    // Directions follow one another for every cell, so that sums have one order; lines of one direction are
    // independent.
    for (const AmbientDirection& direction : ambientDirections(out.shape.axes)) {
        const int lines = direction.axis == 2 ? out.shape.nv : out.shape.nw;
        parallelFor(static_cast<std::size_t>(lines),
            [&](std::size_t line) { addAmbient(out, direction, light.occlusion, static_cast<int>(line), room); });
    }
}

void addSunLight(const Light& light, const glm::vec3& eye, const LightWorkspace& room, LightGrid& out)
{
    const SunJob job = sunJob(light, out.shape.axes, eye);
    parallelFor(static_cast<std::size_t>(out.shape.nv),
        [&](std::size_t row) { addSun(room, job, static_cast<int>(row), out); });
}

void addCells(const GridShape& shape, const AlignedArray<float>& from, AlignedArray<float>& to)
{
    const auto planes = static_cast<std::size_t>(shape.nw);
    const std::size_t plane = shape.cells() / planes;
    parallelFor(planes, [&](std::size_t w) {
        for (std::size_t i = w * plane; i < (w + 1) * plane; ++i) {
            to[i] += from[i];
        }
    });
}

/// Whether two layers are put into the density as one: the detail that they have changes it alike.
bool isAlike(const LitLayer& one, const LitLayer& other)
{
    return one.detail == nullptr || other.detail == nullptr ? one.detail == other.detail
                                                            : shadowsAlike(*one.detail, *other.detail);
}

/// Densities of all layers: detail is put into the density of its own layers alone.
void addDensities(LitLayers layers, LightWorkspace& room, LightGrid& out)
{
    const bool detailed = std::any_of(layers.begin(), layers.end(), [](const LitLayer& layer) { return layer.detail; });
    room.layer.shape = out.shape;
    std::array<LitLayer, kMaxLayers> group;
    bool isFirst = true;
    for (auto layer = layers.begin(); layer != layers.end(); ++layer) {
        const auto isLike = [&](const LitLayer& other) {
            return other.appearance->count > 0 && isAlike(*layer, other);
        };
        if (layer->appearance->count == 0 || std::any_of(layers.begin(), layer, isLike)) {
            continue; // there is nothing of it, or it was put in with that one
        }
        const auto end = std::copy_if(layer, layers.end(), group.begin(), isLike);
        LightGrid& grid = isFirst ? out : room.layer;
        splatParticles(std::span(group.begin(), end), out.shape, room, grid.density);
        if (layer->detail != nullptr) {
            putDetailIntoDensity(*layer->detail, grid);
        } else if (detailed) {
            grid.plain = grid.density;
        }
        if (!isFirst) {
            addCells(out.shape, grid.plain, out.plain);
            addCells(out.shape, grid.density, out.density);
        }
        isFirst = false;
    }
    if (isFirst) {
        out.density.assign(out.shape.cells() + kPadding, 0.0F);
    }
}

} // namespace

SunJob sunJob(const Light& light, const Axes& axes, const glm::vec3& eye)
{
    SunJob job;
    job.eye = {glm::dot(eye, axes.u), glm::dot(eye, axes.v), glm::dot(eye, axes.w)};
    job.intensity = light.intensity;
    job.shadow = light.shadow;
    job.scattering = light.scattering;
    job.anisotropy = light.anisotropy;
    return job;
}

void splatParticles(LitLayers layers, const GridShape& shape, LightWorkspace& room, AlignedArray<float>& out)
{
    const std::size_t cells = shape.cells();
    // What covers most of its disc is the measure of the others: of one layer, its mass is counted as it is.
    float cover = 0.0F;
    std::size_t chunks = 0;
    std::size_t count = 0;
    for (const LitLayer& layer : layers) {
        cover = std::max(cover, layer.appearance->cover.mean);
        chunks += layer.frame->particles.chunks();
        count += layer.appearance->count;
    }
    const auto weightOf = [&](const LitLayer& layer) {
        return cover > 0.0F ? layer.appearance->cover.mean / cover : 1.0F;
    };
    // The sum over all particles must fit into 32 bits, whatever cell they meet in.
    constexpr float kMaxUnits = 0x1p31F;
    constexpr float kSmallestMass = 1e-20F;
    float largestMass = kSmallestMass;
    for (const LitLayer& layer : layers) {
        largestMass = std::max(largestMass, layer.appearance->largestMass * weightOf(layer));
    }
    const float unitsPerMass = kMaxUnits / (largestMass * static_cast<float>(count));
    const auto workers = std::min(chunks, parallelThreads());
    room.partial.resize(workers);
    parallelFor(workers, [&](std::size_t worker) {
        room.partial[worker].assign(cells, 0U);
        std::size_t before = 0; // chunks of the layers before
        for (const LitLayer& layer : layers) {
            const float units = unitsPerMass * weightOf(layer);
            const std::size_t own = layer.frame->particles.chunks();
            for (std::size_t chunk = (worker + workers - before % workers) % workers; chunk < own; chunk += workers) {
                splatChunk(layer.frame->particles, *layer.appearance, shape, units, chunk, room.partial[worker].data());
            }
            before += own;
        }
    });
    const float volume = shape.cell * shape.cell * shape.cell;
    const float perUnit = kPi * cover / (unitsPerMass * volume);
    out.resize(cells + kPadding);
    const auto planes = static_cast<std::size_t>(shape.nw);
    const std::size_t plane = cells / planes;
    parallelFor(planes, [&](std::size_t w) {
        for (std::size_t i = w * plane; i < (w + 1) * plane; ++i) {
            std::uint32_t sum = 0;
            for (const AlignedArray<std::uint32_t>& part : room.partial) {
                sum += part[i];
            }
            out[i] = static_cast<float>(sum) * perUnit;
        }
    });
    std::fill(out.begin() + static_cast<std::ptrdiff_t>(cells), out.end(), 0.0F);
}

void fillDensity(LitLayers layers, const Light& light, const Axes& axes, LightWorkspace& room, LightGrid& out)
{
    const bool dense = needsDensity(layers, light);
    out.shape = gridShape(LitBounds(layers), light, axes, finestResolution(light, dense));
    out.plain.clear();
    if (dense) {
        addDensities(layers, room, out);
    } else {
        out.density.assign(out.shape.cells() + kPadding, 0.0F);
    }
}

void lightSmoke(LitLayers layers, const glm::vec3& eye, LightWorkspace& room, LightGrid& out)
{
    if (std::all_of(layers.begin(), layers.end(), [](const LitLayer& each) { return each.appearance->count == 0; })) {
        out.shape = {};
        out.density.assign(1 + kPadding, 0.0F);
        out.plain.clear();
        out.light.assign(4, 0.0F);
        out.diffuse.clear();
        return;
    }
    const Light& light = layers.front().effect->light;
    fillDensity(layers, light, lightAxes(light.direction), room, out);
    const std::size_t cells = out.shape.cells();
    out.light.resize(cells * 4);
    room.air.assign(static_cast<std::size_t>(out.shape.nu) + kPadding, 0.0F);
    room.sky.assign(cells, 0.0F);
    room.ground.assign(cells, 0.0F);
    addAmbientLight(light, room, out);
    addSunLight(light, eye, room, out);
    scatterManyTimes(light, room, out);
}

} // namespace fumage
