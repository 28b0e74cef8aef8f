#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lighting/light_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/hash-inl.h"
#include "core/base/math-inl.h"
#include "core/lighting/grid_cell-inl.h"
#include "core/lighting/light_kernel.h"
#include "core/lighting/scattering-inl.h"

#include <algorithm>
#include <array>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;

/// Some particles in the grid, between the vector and the scalar half of the work.
struct SplatBlock {
    static constexpr std::size_t kSize = 128;
    static constexpr std::size_t kPairs = 4;
    HWY_ALIGN std::int32_t corner[kSize];
    HWY_ALIGN std::int32_t all[kSize]; ///< units of the particle in all eight cells
    HWY_ALIGN std::int32_t pairs[kPairs][2 * kSize]; ///< units for a cell and the next along u
};

/// Makes whole numbers of amounts so that their sum is the whole part of the amounts' sum, from a start in [0, 1) on.
/// With random starts the mean of every whole number is its amount, however small: rounding loses nothing.
struct SharedRounding {
    V sum;
    hn::Vec<hn::RebindToSigned<D>> given = hn::Zero(hn::RebindToSigned<D>());

    HWY_INLINE auto take(V amount)
    {
        sum = sum + amount;
        const auto total = hn::ConvertTo(hn::RebindToSigned<D>(), sum);
        const auto units = total - given;
        given = total;
        return units;
    }
};

HWY_INLINE void placeBlock(const Particles& particles, const Appearance& appearance, const GridShape& shape,
    float unitsPerMass, std::size_t begin, SplatBlock& block)
{
    const D d;
    const hn::RebindToSigned<D> di;
    for (std::size_t i = 0; i < SplatBlock::kSize; i += hn::Lanes(d)) {
        const std::size_t at = begin + i;
        const V radius = hn::Load(d, appearance.radius.data() + at);
        const V alpha = hn::Load(d, appearance.alpha.data() + at);
        const auto key = hn::Load(hn::RebindToUnsigned<D>(), particles.key.data() + at);
        const GridCell<D> cell = gridCellAt(d, shape, load(d, particles.x, particles.y, particles.z, at));
        V mass = alpha * (radius * radius) * unitsPerMass;
        if (!appearance.left.empty()) {
            mass = mass * hn::Load(d, appearance.left.data() + at);
        }
        const V back = mass * cell.fraction.z;
        const V front = mass - back;
        const V frontTop = front * cell.fraction.y;
        const V backTop = back * cell.fraction.y;
        SharedRounding rounding{unitFloat(d, key)};
        const auto share = [&](std::size_t pair, V amount) HWY_ATTR {
            const V right = amount * cell.fraction.x;
            const auto units = rounding.take(amount - right);
            hn::StoreInterleaved2(units, rounding.take(right), di, block.pairs[pair] + 2 * i);
        };
        share(0, front - frontTop);
        share(1, frontTop);
        share(2, back - backTop);
        share(3, backTop);
        hn::Store(cell.corner, di, block.corner + i);
        hn::Store(rounding.given, di, block.all + i);
    }
}

/// Adds to two cells at once: sums stay below 2^32, so that nothing is carried from one to the other.
HWY_INLINE void addToPair(std::uint32_t* cells, const std::int32_t* units)
{
    std::uint64_t sum = 0;
    std::uint64_t added = 0;
    std::memcpy(&sum, cells, sizeof(sum));
    std::memcpy(&added, units, sizeof(added));
    sum += added;
    std::memcpy(cells, &sum, sizeof(sum));
}

/// Cells and units of some particles first, with vectors, then the scattered additions one by one.
void splat(const Particles& particles, const Appearance& appearance, const GridShape& shape, float unitsPerMass,
    std::size_t chunk, std::uint32_t* density)
{
    const auto nu = static_cast<std::size_t>(shape.nu);
    const std::size_t plane = nu * static_cast<std::size_t>(shape.nv);
    const std::array<std::size_t, SplatBlock::kPairs> offsets{0, nu, plane, plane + nu};
    const std::size_t end = (chunk + 1) * Particles::kChunk;
    SplatBlock block;
    for (std::size_t begin = chunk * Particles::kChunk; begin < end; begin += SplatBlock::kSize) {
        placeBlock(particles, appearance, shape, unitsPerMass, begin, block);
        for (std::size_t i = 0; i < SplatBlock::kSize; ++i) {
            if (block.all[i] == 0) {
                continue;
            }
            for (std::size_t pair = 0; pair < SplatBlock::kPairs; ++pair) {
                addToPair(density + block.corner[i] + offsets[pair], block.pairs[pair] + 2 * i);
            }
        }
    }
}

/// Room for one float for each cell of a line along u, and for a vector past its end.
using LineOfCells = std::array<float, kMaxLightResolution + kAlignment / sizeof(float)>;

/// exp(-depth * scale) * weights, added to the sky and ground of a line of cells, u fastest.
HWY_INLINE void addTransmittance(const float* HWY_RESTRICT depth, std::size_t count, const AmbientDirection& direction,
    float scale, float* HWY_RESTRICT sky, float* HWY_RESTRICT ground)
{
    const D d;
    const V skyWeight = hn::Set(d, direction.sky);
    const V groundWeight = hn::Set(d, direction.ground);
    const auto through = [&](std::size_t i) HWY_ATTR { return exponential(d, hn::LoadU(d, depth + i) * -scale); };
    std::size_t i = 0;
    for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
        const V light = through(i);
        hn::StoreU(light * skyWeight + hn::LoadU(d, sky + i), d, sky + i);
        hn::StoreU(light * groundWeight + hn::LoadU(d, ground + i), d, ground + i);
    }
    if (i < count) {
        // The next line belongs to another task: the last vector is added cell by cell.
        HWY_ALIGN float rest[HWY_MAX_BYTES / sizeof(float)];
        hn::Store(through(i), d, rest);
        for (std::size_t lane = 0; i + lane < count; ++lane) {
            sky[i + lane] += rest[lane] * direction.sky;
            ground[i + lane] += rest[lane] * direction.ground;
        }
    }
}

/// depth[i] += half the sum of two lines of density, in cells.
HWY_INLINE void addHalf(
    const float* HWY_RESTRICT a, const float* HWY_RESTRICT b, std::size_t count, float* HWY_RESTRICT depth)
{
    const D d;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const V sum = hn::LoadU(d, a + i) + hn::LoadU(d, b + i);
        hn::StoreU(0.5F * sum + hn::LoadU(d, depth + i), d, depth + i);
    }
}

/// Depth along a line of u itself: to the middle of each cell.
HWY_INLINE void sumAlong(const float* density, std::size_t count, bool reversed, float* depth)
{
    float sum = 0.0F;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t u = reversed ? count - 1 - i : i;
        sum += 0.5F * density[u];
        depth[u] = sum;
        sum += 0.5F * density[u];
    }
}

void ambient(const LightGrid& grid, const AmbientDirection& direction, float occlusion, int line, LightWorkspace& to)
{
    const auto nu = static_cast<std::size_t>(grid.shape.nu);
    const auto nv = static_cast<std::size_t>(grid.shape.nv);
    const auto nw = static_cast<std::size_t>(grid.shape.nw);
    const float scale = occlusion * grid.shape.cell;
    const auto index = static_cast<std::size_t>(line);
    // Densities are padded by a vector, so that the last line may be read past its end.
    LineOfCells depth{};
    const auto lineOf = [&](std::size_t v, std::size_t w) { return (w * nv + v) * nu; };
    const auto addLight = [&](std::size_t at) HWY_ATTR {
        addTransmittance(depth.data(), nu, direction, scale, to.sky.data() + at, to.ground.data() + at);
    };
    if (direction.axis == 0) {
        for (std::size_t v = 0; v < nv; ++v) {
            sumAlong(grid.density.data() + lineOf(v, index), nu, direction.reversed, depth.data());
            addLight(lineOf(v, index));
        }
        return;
    }
    const std::size_t count = direction.axis == 1 ? nv : nw;
    const float* before = to.air.data();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t step = direction.reversed ? count - 1 - i : i;
        const std::size_t at = direction.axis == 1 ? lineOf(step, index) : lineOf(index, step);
        const float* here = grid.density.data() + at;
        addHalf(here, before, nu, depth.data());
        addLight(at);
        before = here;
    }
}

void sun(const LightWorkspace& from, const SunJob& job, int row, LightGrid& grid)
{
    const D d;
    const GridShape& shape = grid.shape;
    const auto nu = static_cast<std::size_t>(shape.nu);
    const auto v = static_cast<std::size_t>(row);
    LineOfCells depth{};
    const float* before = from.air.data();
    for (std::size_t w = 0; w < static_cast<std::size_t>(shape.nw); ++w) {
        const std::size_t at = (w * static_cast<std::size_t>(shape.nv) + v) * nu;
        const float* here = grid.density.data() + at;
        addHalf(here, before, nu, depth.data());
        before = here;
        // The way to the eye; light travels along +w.
        const float dv = job.eye.y - (shape.origin.y + static_cast<float>(v) * shape.cell);
        const float dw = job.eye.z - (shape.origin.z + static_cast<float>(w) * shape.cell);
        for (std::size_t i = 0; i < nu; i += hn::Lanes(d)) {
            constexpr float kNeverZero = 1e-12F;
            const V du = (job.eye.x - shape.origin.x) - (hn::Iota(d, 0.0F) + static_cast<float>(i)) * shape.cell;
            const V distance = hn::Sqrt(du * du + (dv * dv + dw * dw + kNeverZero));
            const V tau = hn::LoadU(d, depth.data() + i) * (shape.cell * job.shadow);
            HWY_ALIGN float bright[HWY_MAX_BYTES / sizeof(float)];
            HWY_ALIGN float taus[HWY_MAX_BYTES / sizeof(float)];
            hn::Store(scattered(d, job, tau, dw / distance), d, bright);
            hn::Store(tau, d, taus);
            const std::size_t n = std::min(hn::Lanes(d), nu - i);
            for (std::size_t lane = 0; lane < n; ++lane) {
                float* cell = grid.light.data() + (at + i + lane) * 4;
                cell[0] = bright[lane];
                cell[1] = from.sky[at + i + lane];
                cell[2] = from.ground[at + i + lane];
                cell[3] = taus[lane];
            }
        }
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(splat);
HWY_EXPORT(ambient);
HWY_EXPORT(sun);

void splatChunk(const Particles& particles, const Appearance& appearance, const GridShape& shape, float unitsPerMass,
    std::size_t chunk, std::uint32_t* density)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(splat);
    kernel(particles, appearance, shape, unitsPerMass, chunk, density);
}

void addAmbient(const LightGrid& grid, const AmbientDirection& direction, float occlusion, int line, LightWorkspace& to)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(ambient);
    kernel(grid, direction, occlusion, line, to);
}

void addSun(const LightWorkspace& from, const SunJob& job, int row, LightGrid& grid)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(sun);
    kernel(from, job, row, grid);
}

} // namespace fumage
#endif
