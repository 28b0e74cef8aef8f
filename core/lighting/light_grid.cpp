#include "core/lighting/light_grid.h"

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/base/vector.h"
#include "core/lighting/light_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fumage {

namespace {

/// Mean over a disc of the soft profile (1 - r^2)^2.
constexpr float kProfileMean = 1.0F / 3.0F;

constexpr std::size_t kPadding = kAlignment / sizeof(float);

GridShape gridShape(const Appearance& appearance, const Axes& axes, int resolution)
{
    constexpr float kSmallestCloud = 1e-3F;
    const glm::vec3 extent = appearance.high - appearance.low;
    GridShape shape;
    shape.axes = axes;
    shape.cell = std::max({extent.x, extent.y, extent.z, kSmallestCloud}) / static_cast<float>(std::max(1, resolution - 2));
    shape.origin = appearance.low - glm::vec3(0.5F * shape.cell);
    // One cell of air on every side, so that bounds never cut a particle in half.
    const auto count = [&](float length) { return std::min(resolution, static_cast<int>(std::ceil(length / shape.cell)) + 2); };
    shape.nu = count(extent.x);
    shape.nv = count(extent.y);
    shape.nw = count(extent.z);
    return shape;
}

void splatAll(const Frame& frame, const Appearance& appearance, LightWorkspace& room, LightGrid& out)
{
    const std::size_t cells = out.shape.cells();
    const std::size_t chunks = frame.particles.chunks();
    // The sum over all particles must fit into 32 bits, whatever cell they meet in.
    constexpr float kMostUnits = 0x1p31F;
    constexpr float kSmallestMass = 1e-20F;
    const float unitsPerMass = kMostUnits / (std::max(appearance.largestMass, kSmallestMass) * static_cast<float>(chunks * Particles::kChunk));
    const auto workers = std::min(chunks, parallelThreads());
    room.partial.resize(workers);
    parallelFor(workers, [&](std::size_t worker) {
        room.partial[worker].assign(cells, 0U);
        for (std::size_t chunk = worker; chunk < chunks; chunk += workers) {
            splatChunk(frame.particles, appearance, out.shape, unitsPerMass, chunk, room.partial[worker].data());
        }
    });
    const float volume = out.shape.cell * out.shape.cell * out.shape.cell;
    const float perUnit = kPi * kProfileMean / (unitsPerMass * volume);
    out.density.resize(cells + kPadding);
    const auto planes = static_cast<std::size_t>(out.shape.nw);
    const std::size_t plane = cells / planes;
    parallelFor(planes, [&](std::size_t w) {
        for (std::size_t i = w * plane; i < (w + 1) * plane; ++i) {
            std::uint32_t sum = 0;
            for (const AlignedArray<std::uint32_t>& part : room.partial) {
                sum += part[i];
            }
            out.density[i] = static_cast<float>(sum) * perUnit;
        }
    });
    std::fill(out.density.begin() + static_cast<std::ptrdiff_t>(cells), out.density.end(), 0.0F);
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

} // namespace

Axes lightAxes(const glm::vec3& direction)
{
    const PlaneBasis plane = planeBasis(direction);
    return {plane.across, plane.along, direction};
}

void lightSmoke(const Frame& frame, const SampledEffect& effect, const Appearance& appearance, const glm::vec3& eye, LightWorkspace& room, LightGrid& out)
{
    const Axes axes = lightAxes(effect->light.direction);
    if (appearance.empty) {
        out.shape = {};
        out.light.assign(4, 0.0F);
        return;
    }
    out.shape = gridShape(appearance, axes, effect->light.resolution);
    splatAll(frame, appearance, room, out);
    out.light.resize(out.shape.cells() * 4);
    room.sky.assign(out.shape.cells(), 0.0F);
    room.ground.assign(out.shape.cells(), 0.0F);
    room.air.assign(static_cast<std::size_t>(out.shape.nu) + kPadding, 0.0F);

    SunJob job;
    job.eye = {glm::dot(eye, axes.u), glm::dot(eye, axes.v), glm::dot(eye, axes.w)};
    job.intensity = effect->light.intensity;
    job.shadow = effect->light.shadow;
    job.scattering = effect->light.scattering;
    job.anisotropy = effect->light.anisotropy;
    // Directions follow one another for every cell, so that sums have one order; lines of one direction are independent.
    for (const AmbientDirection& direction : ambientDirections(axes)) {
        const int lines = direction.axis == 2 ? out.shape.nv : out.shape.nw;
        parallelFor(static_cast<std::size_t>(lines), [&](std::size_t line) { addAmbient(out, direction, effect->light.occlusion, static_cast<int>(line), room); });
    }
    parallelFor(static_cast<std::size_t>(out.shape.nv), [&](std::size_t row) { addSun(room, job, static_cast<int>(row), out); });
}

} // namespace fumage
