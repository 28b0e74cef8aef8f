#include "core/lighting/six_way.h"

#include "core/base/parallel.h"
#include "core/lighting/multiple_scattering.h"
#include "core/lighting/six_way_kernel.h"
#include "core/lighting/soft_light.h"

namespace fumage {

namespace {

constexpr std::size_t kPadding = kAlignment / sizeof(float);

/// Puts the directions of each cell together, as trilinear interpolation reads them.
void interleave(const std::array<AlignedArray<float>, SixWayLight::kDirections>& single, std::size_t first,
    std::size_t cells, AlignedArray<float>& to)
{
    to.resize(cells * SixWayLight::kStride);
    constexpr std::size_t kBlock = 16384;
    parallelFor((cells + kBlock - 1) / kBlock, [&](std::size_t block) {
        const std::size_t last = std::min(cells, (block + 1) * kBlock);
        for (std::size_t i = block * kBlock; i < last; ++i) {
            float* cell = to.data() + i * SixWayLight::kStride;
            cell[0] = single[first][i];
            cell[1] = single[first + 2][i];
            cell[2] = single[first + 4][i];
            cell[3] = 0.0F;
        }
    });
}

/// Fills the cells of both halves of the directions.
void shineSixWays(const SunJob& sun, SixWayLight& light, AlignedArray<float>& above, AlignedArray<float>& below)
{
    const std::size_t cells = light.grid.shape.cells();
    parallelFor(SixWayLight::kDirections, [&](std::size_t direction) {
        AlignedArray<float>& to = light.single[direction];
        to.resize(cells + kPadding);
        addSunFrom(light.grid, sun, static_cast<int>(direction / 2), direction % 2 == 0, to.data());
    });
    interleave(light.single, 0, cells, above);
    interleave(light.single, 1, cells, below);
}

/// What is left of a light, without what smoke makes of it.
SunJob throughSmoke(SunJob sun)
{
    sun.anisotropy = 0.0F;
    sun.scattering = 0.0F;
    return sun;
}

} // namespace

void lightSixWays(LitLayers layers, const Axes& axes, const glm::vec3& eye, LightWorkspace& room, SixWayLight& out)
{
    if (LitBounds(layers).count == 0) {
        out.grid.shape = {};
        out.fromAbove.assign(SixWayLight::kStride, 0.0F);
        out.fromBelow.assign(SixWayLight::kStride, 0.0F);
        return;
    }
    Light light = layers.front().effect->light;
    light.intensity = 1.0F;
    fillDensity(layers, light, axes, room, out.grid);
    const SunJob sun = sunJob(light, axes, eye);
    shineSixWays(sun, out, out.fromAbove, out.fromBelow);
    if (light.multipleScattering > 0.0F) {
        shineSixWays(throughSmoke(sun), out, out.diffuseAbove, out.diffuseBelow);
        addScatteredManyTimes(light, out.grid, room, out.diffuseAbove, out.fromAbove);
        addScatteredManyTimes(light, out.grid, room, out.diffuseBelow, out.fromBelow);
    }
    softenCells(out.grid.shape, SixWayLight::kStride, out.fromAbove, room.soft);
    softenCells(out.grid.shape, SixWayLight::kStride, out.fromBelow, room.soft);
}

} // namespace fumage
