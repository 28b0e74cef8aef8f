#include "core/lighting/overlap.h"

#include "core/base/parallel.h"
#include "core/lighting/overlap_kernel.h"

#include <algorithm>

namespace fumage {

namespace {

/// How many cells of the light's grid make one that is about as large as particles.
int cellsInOne(const Appearance& appearance, const GridShape& shape)
{
    constexpr float kTypical = 0.6F; // a particle's radius over the largest
    // Of any grid one holds all long before; numbers of cells stay far from where they would overflow.
    constexpr float kMaxInOne = 1e6F;
    return std::max(1, static_cast<int>(std::min(kMaxInOne, kTypical * appearance.largestRadius / shape.cell)));
}

/// A grid of cells that are several times as large, over the same place.
GridShape coarser(const GridShape& shape, int factor)
{
    GridShape out = shape;
    out.cell = shape.cell * static_cast<float>(factor);
    out.origin = shape.origin + 0.5F * (out.cell - shape.cell);
    const auto count = [&](int cells) { return (cells + factor - 1) / factor; };
    out.nu = count(shape.nu);
    out.nv = count(shape.nv);
    out.nw = count(shape.nw);
    return out;
}

/// Means over the cells of a finer grid. What lies beyond its end is empty.
void gatherPlane(const LightGrid& from, int factor, int plane, OverlapWorkspace& to)
{
    const GridShape& fine = from.shape;
    const GridShape& coarse = to.shape;
    float* out = to.density.data()
        + static_cast<std::size_t>(plane) * static_cast<std::size_t>(coarse.nu) * static_cast<std::size_t>(coarse.nv);
    std::fill_n(out, static_cast<std::size_t>(coarse.nu) * static_cast<std::size_t>(coarse.nv), 0.0F);
    const auto edge = static_cast<float>(factor);
    const float share = 1.0F / (edge * edge * edge);
    for (int w = plane * factor; w < std::min((plane + 1) * factor, fine.nw); ++w) {
        for (int v = 0; v < fine.nv; ++v) {
            const float* row = from.densityOfParticles().data()
                + (static_cast<std::size_t>(w) * static_cast<std::size_t>(fine.nv) + static_cast<std::size_t>(v))
                    * static_cast<std::size_t>(fine.nu);
            float* sums = out + static_cast<std::size_t>(v / factor) * static_cast<std::size_t>(coarse.nu);
            for (int u = 0; u < fine.nu; ++u) {
                sums[u / factor] += row[u] * share;
            }
        }
    }
}

/// Finds how dense the smoke around cells that are about as large as particles is, where it is not known yet.
void findDensity(const LightGrid& light, int factor, OverlapWorkspace& room)
{
    if (room.factor == factor) {
        return;
    }
    room.factor = factor;
    room.shape = coarser(light.shape, factor);
    constexpr std::size_t kPadding = kAlignment / sizeof(float);
    room.density.resize(room.shape.cells() + kPadding);
    room.around.resize(room.shape.cells());
    const auto planes = static_cast<std::size_t>(room.shape.nw);
    parallelFor(planes, [&](std::size_t plane) { gatherPlane(light, factor, static_cast<int>(plane), room); });
    parallelFor(planes, [&](std::size_t plane) {
        findDensityAround(room.shape, room.density.data(), static_cast<int>(plane), room.around.data());
    });
}

} // namespace

void inflateSparseParticles(const Frame& frame, const SampledEffect& effect, const LightGrid& light,
    OverlapWorkspace& room, Appearance& appearance)
{
    if (effect->look.overlap <= 1.0F || appearance.count == 0) {
        return;
    }
    findDensity(light, cellsInOne(appearance, light.shape), room);
    parallelFor(frame.particles.chunks(), [&](std::size_t chunk) {
        growChunk(frame.particles, room.shape, room.around.data(), effect->look.overlap, chunk, appearance);
    });
}

} // namespace fumage
