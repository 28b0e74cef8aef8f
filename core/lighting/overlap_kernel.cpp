#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lighting/overlap_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/math-inl.h"
#include "core/base/math.h"
#include "core/lighting/grid_cell-inl.h"
#include "core/lighting/overlap_kernel.h"

#include <algorithm>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using DI = hn::RebindToSigned<D>;
using VI = hn::Vec<DI>;

/// Adds weight times a row of the density to sums.
HWY_INLINE void addRow(const float* HWY_RESTRICT row, std::size_t count, float weight, float* HWY_RESTRICT sums)
{
    const D d;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        hn::StoreU(hn::LoadU(d, row + i) * weight + hn::LoadU(d, sums + i), d, sums + i);
    }
}

void densityAround(const GridShape& shape, const float* HWY_RESTRICT density, int plane, float* HWY_RESTRICT around)
{
    constexpr std::array<float, 3> kWeights{0.25F, 0.5F, 0.25F};
    constexpr std::size_t kVector = kAlignment / sizeof(float);
    const auto count = static_cast<std::size_t>(shape.nu);
    for (int v = 0; v < shape.nv; ++v) {
        // A cell of nothing at either end, and room for a vector past it.
        std::array<float, 1 + kMaxLightResolution + 1 + kVector> sums{};
        for (std::size_t dw = 0; dw < kWeights.size(); ++dw) {
            for (std::size_t dv = 0; dv < kWeights.size(); ++dv) {
                const int w = plane + static_cast<int>(dw) - 1;
                const int row = v + static_cast<int>(dv) - 1;
                if (w < 0 || w >= shape.nw || row < 0 || row >= shape.nv) {
                    continue;
                }
                const std::size_t at =
                    (static_cast<std::size_t>(w) * static_cast<std::size_t>(shape.nv) + static_cast<std::size_t>(row))
                    * count;
                addRow(density + at, count, kWeights[dw] * kWeights[dv], sums.data() + 1);
            }
        }
        sums[count + 1] = 0.0F; // the last vector went on into the next row
        float* to = around
            + (static_cast<std::size_t>(plane) * static_cast<std::size_t>(shape.nv) + static_cast<std::size_t>(v))
                * count;
        for (std::size_t i = 0; i < count; ++i) {
            to[i] = kWeights[0] * sums[i] + kWeights[1] * sums[i + 1] + kWeights[2] * sums[i + 2];
        }
    }
}

/// Between the eight cells around points.
HWY_INLINE V sampled(D d, const GridShape& shape, const float* values, const GridCell<D>& cell)
{
    const DI di;
    const int along = shape.nu > 1 ? 1 : 0;
    const int up = shape.nv > 1 ? shape.nu : 0;
    const int in = shape.nw > 1 ? shape.nu * shape.nv : 0;
    const auto between = [](V a, V b, V t) HWY_ATTR { return a + (b - a) * t; };
    const auto row = [&](VI first) HWY_ATTR {
        return between(
            hn::GatherIndex(d, values, first), hn::GatherIndex(d, values, first + hn::Set(di, along)), cell.fraction.x);
    };
    const auto side = [&](VI first)
                          HWY_ATTR { return between(row(first), row(first + hn::Set(di, up)), cell.fraction.y); };
    return between(side(cell.corner), side(cell.corner + hn::Set(di, in)), cell.fraction.z);
}

/// What a particle that is spread over the cells around it, and those over their neighbours, finds of itself where it
/// is: the share of its density in one cell. For one axis s (s/2 + (1-s)/4) + (1-s) ((1-s)/2 + s/4) = 1/2 - s (1-s) /
/// 2, s the way between two cells. Where finer cells were gathered it is nearly so.
HWY_INLINE V ownShare(const Vec3<V>& fraction)
{
    const auto along = [](V s) HWY_ATTR { return 0.5F - 0.5F * (s * (1.0F - s)); };
    return along(fraction.x) * along(fraction.y) * along(fraction.z);
}

void grow(const Particles& particles, const GridShape& shape, const float* around, float overlap, std::size_t chunk,
    Appearance& appearance)
{
    const D d;
    constexpr float kMaxGrowth = 3.0F;
    constexpr float kThird = 1.0F / 3.0F;
    constexpr float kNoAlpha = 1e-12F;
    const float perVolume = kPi * appearance.cover.mean / (shape.cell * shape.cell * shape.cell);
    // 4/3 pi r^3 over what the particle covers, by r
    const float ballsADisc = 4.0F * (Coverage::kSoftDisc / appearance.cover.mean);
    const std::size_t begin = chunk * Particles::kChunk;
    for (std::size_t i = begin; i < begin + Particles::kChunk; i += hn::Lanes(d)) {
        const V radius = hn::Load(d, appearance.radius.data() + i);
        const V alpha = hn::Load(d, appearance.alpha.data() + i);
        const V dense = appearance.left.empty() ? alpha : alpha * hn::Load(d, appearance.left.data() + i);
        const GridCell<D> cell = gridCellAt(d, shape, load(d, particles.x, particles.y, particles.z, i));
        const V own = dense * (radius * radius) * perVolume * ownShare(cell.fraction);
        const V others = hn::Max(hn::Zero(d), sampled(d, shape, around, cell) - own);
        const V present = 1.0F + ballsADisc * radius * others / hn::Max(dense, hn::Set(d, kNoAlpha));
        const V lacking = hn::Max(hn::Set(d, 1.0F), overlap / present);
        const V growth = hn::Min(hn::Set(d, kMaxGrowth), exponential(d, kThird * logarithm(d, lacking)));
        hn::Store(radius * growth, d, appearance.radius.data() + i);
        hn::Store(alpha / (growth * growth), d, appearance.alpha.data() + i);
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(densityAround);
HWY_EXPORT(grow);

void findDensityAround(const GridShape& shape, const float* density, int plane, float* around)
{
    HWY_DYNAMIC_DISPATCH(densityAround)
    (shape, density, plane, around);
}

void growChunk(const Particles& particles, const GridShape& shape, const float* around, float overlap,
    std::size_t chunk, Appearance& appearance)
{
    HWY_DYNAMIC_DISPATCH(grow)
    (particles, shape, around, overlap, chunk, appearance);
}

} // namespace fumage
#endif
