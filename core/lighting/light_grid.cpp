#include "core/lighting/light_grid.h"

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/base/vector.h"
#include "core/lighting/detail_light.h"
#include "core/lighting/light_kernel.h"

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
bool needsDensity(const Effect& effect)
{
    const Light& light = effect.light;
    const bool shadows = light.intensity > 0.0F && light.shadow > 0.0F;
    const bool glowsByOpenness = effect.glow.emission > 0.0F && effect.glow.hotCore > 0.0F;
    const bool occludes = light.occlusion > 0.0F && (light.ambient > 0.0F || glowsByOpenness);
    return shadows || occludes || effect.look.overlap > 1.0F || hasDetail(effect);
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
float smallestCell(const Appearance& appearance, const Light& light)
{
    constexpr float kCellsAParticle = 16.0F;
    constexpr float kThird = 1.0F / 3.0F;
    constexpr float kNoVolume = 1e-30F;
    const glm::vec3 extent = appearance.high - appearance.low;
    const float volume = std::max(kNoVolume, extent.x * extent.y * extent.z);
    const float filled = portablePow(volume / (kCellsAParticle * static_cast<float>(appearance.count)), kThird);
    constexpr float kTypical = 0.4F; // a particle's mass over the largest; of the built-in presets 0.32 to 0.58
    constexpr float kMaxOwnDepth = 0.3F; // optical depth of one particle spread over a cell
    const float crossSection =
        kTypical * kPi * appearance.cover.mean * appearance.largestMass * std::max(light.shadow, light.occlusion);
    return std::max(filled, std::sqrt(crossSection / kMaxOwnDepth));
}

GridShape gridShape(const Appearance& appearance, const Light& light, const Axes& axes, int resolution)
{
    GridShape shape;
    shape.axes = axes;
    if (resolution == 1) {
        return shape;
    }
    constexpr float kSmallestCloud = 1e-3F;
    const glm::vec3 extent = appearance.high - appearance.low;
    const float longest = std::max({extent.x, extent.y, extent.z, kSmallestCloud});
    constexpr float kMinCells = 6.0F; // along the longest edge: less shows no shadow
    shape.finest = longest / static_cast<float>(resolution - 2);
    shape.cell = std::max(shape.finest, std::min(longest / kMinCells, smallestCell(appearance, light)));
    shape.origin = appearance.low - glm::vec3(0.5F * shape.cell);
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

void addAmbientLight(const Effect& effect, LightWorkspace& room, LightGrid& out)
{
    // Directions follow one another for every cell, so that sums have one order; lines of one direction are
    // independent.
    for (const AmbientDirection& direction : ambientDirections(out.shape.axes)) {
        const int lines = direction.axis == 2 ? out.shape.nv : out.shape.nw;
        parallelFor(static_cast<std::size_t>(lines), [&](std::size_t line) {
            addAmbient(out, direction, effect.light.occlusion, static_cast<int>(line), room);
        });
    }
}

void addSunLight(const Effect& effect, const glm::vec3& eye, const LightWorkspace& room, LightGrid& out)
{
    const SunJob job = sunJob(effect.light, out.shape.axes, eye);
    parallelFor(static_cast<std::size_t>(out.shape.nv),
        [&](std::size_t row) { addSun(room, job, static_cast<int>(row), out); });
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

void splatParticles(const Frame& frame, const Appearance& appearance, const GridShape& shape, LightWorkspace& room,
    AlignedArray<float>& out)
{
    const std::size_t cells = shape.cells();
    const std::size_t chunks = frame.particles.chunks();
    // The sum over all particles must fit into 32 bits, whatever cell they meet in.
    constexpr float kMaxUnits = 0x1p31F;
    constexpr float kSmallestMass = 1e-20F;
    const float unitsPerMass =
        kMaxUnits / (std::max(appearance.largestMass, kSmallestMass) * static_cast<float>(appearance.count));
    const auto workers = std::min(chunks, parallelThreads());
    room.partial.resize(workers);
    parallelFor(workers, [&](std::size_t worker) {
        room.partial[worker].assign(cells, 0U);
        for (std::size_t chunk = worker; chunk < chunks; chunk += workers) {
            splatChunk(frame.particles, appearance, shape, unitsPerMass, chunk, room.partial[worker].data());
        }
    });
    const float volume = shape.cell * shape.cell * shape.cell;
    const float perUnit = kPi * appearance.cover.mean / (unitsPerMass * volume);
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

void fillDensity(const Frame& frame, const SampledEffect& effect, const Appearance& appearance, const Axes& axes,
    const DetailField* detail, LightWorkspace& room, LightGrid& out)
{
    const bool dense = needsDensity(effect);
    out.shape = gridShape(appearance, effect->light, axes, finestResolution(effect->light, dense));
    if (dense) {
        splatParticles(frame, appearance, out.shape, room, out.density);
    } else {
        out.density.assign(out.shape.cells() + kPadding, 0.0F);
    }
    out.plain.clear();
    if (detail != nullptr) {
        putDetailIntoDensity(*detail, out);
    }
}

void lightSmoke(const Frame& frame, const SampledEffect& effect, const Appearance& appearance, const glm::vec3& eye,
    const DetailField* detail, LightWorkspace& room, LightGrid& out)
{
    if (appearance.count == 0) {
        out.shape = {};
        out.light.assign(4, 0.0F);
        out.body.assign(1, 0.0F);
        return;
    }
    fillDensity(frame, effect, appearance, lightAxes(effect->light.direction), detail, room, out);
    if (detail != nullptr) {
        findBody(*detail, out);
    }
    const std::size_t cells = out.shape.cells();
    out.light.resize(cells * 4);
    room.air.assign(static_cast<std::size_t>(out.shape.nu) + kPadding, 0.0F);
    room.sky.assign(cells, 0.0F);
    room.ground.assign(cells, 0.0F);
    addAmbientLight(effect, room, out);
    addSunLight(effect, eye, room, out);
}

} // namespace fumage
