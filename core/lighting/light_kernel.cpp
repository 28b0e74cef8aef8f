#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lighting/light_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/math-inl.h"
#include "core/lighting/light_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;

/// Grid coordinates and masses of a chunk first, with vectors, then the scattered additions one by one.
void splat(const Particles& particles, const Appearance& appearance, const GridShape& shape, float unitsPerMass, std::size_t chunk, std::uint32_t* density)
{
    const D d;
    const hn::RebindToSigned<D> di;
    constexpr std::size_t kBlock = 128;
    HWY_ALIGN std::int32_t corner[kBlock];
    HWY_ALIGN float fu[kBlock];
    HWY_ALIGN float fv[kBlock];
    HWY_ALIGN float fw[kBlock];
    HWY_ALIGN float mass[kBlock];
    const V perCell = hn::Set(d, 1.0F / shape.cell);
    const auto nu = static_cast<std::size_t>(shape.nu);
    const std::size_t plane = nu * static_cast<std::size_t>(shape.nv);
    const std::size_t begin = chunk * Particles::kChunk;
    for (std::size_t block = begin; block < begin + Particles::kChunk; block += kBlock) {
        for (std::size_t i = 0; i < kBlock; i += hn::Lanes(d)) {
            const V x = hn::Load(d, particles.x.data() + block + i);
            const V y = hn::Load(d, particles.y.data() + block + i);
            const V z = hn::Load(d, particles.z.data() + block + i);
            const V radius = hn::Load(d, appearance.radius.data() + block + i);
            const V alpha = hn::Load(d, appearance.alpha.data() + block + i);
            const auto coordinate = [&](const glm::vec3& axis, float origin, int count, V& fraction) {
                const V along = hn::Add(hn::Add(hn::Mul(x, hn::Set(d, axis.x)), hn::Mul(y, hn::Set(d, axis.y))), hn::Mul(z, hn::Set(d, axis.z)));
                // Dead particles lie anywhere: they are kept inside, and their mass is 0.
                const V cells = hn::Min(hn::Max(hn::Mul(hn::Sub(along, hn::Set(d, origin)), perCell), hn::Zero(d)), hn::Set(d, static_cast<float>(count) - 1.001F));
                const V whole = hn::Floor(cells);
                fraction = hn::Sub(cells, whole);
                return hn::ConvertTo(di, whole);
            };
            V u = hn::Zero(d);
            V v = hn::Zero(d);
            V w = hn::Zero(d);
            const auto iu = coordinate(shape.axes.u, shape.origin.x, shape.nu, u);
            const auto iv = coordinate(shape.axes.v, shape.origin.y, shape.nv, v);
            const auto iw = coordinate(shape.axes.w, shape.origin.z, shape.nw, w);
            const auto row = hn::Add(hn::Mul(iw, hn::Set(di, shape.nv)), iv);
            hn::Store(hn::Add(hn::Mul(row, hn::Set(di, shape.nu)), iu), di, corner + i);
            hn::Store(u, d, fu + i);
            hn::Store(v, d, fv + i);
            hn::Store(w, d, fw + i);
            hn::Store(hn::Mul(hn::Mul(alpha, hn::Mul(radius, radius)), hn::Set(d, unitsPerMass)), d, mass + i);
        }
        for (std::size_t i = 0; i < kBlock; ++i) {
            if (mass[i] <= 0.0F) {
                continue;
            }
            const auto add = [](std::uint32_t* pair, float amount, float fraction) {
                const float right = amount * fraction;
                pair[0] += static_cast<std::uint32_t>(static_cast<std::int32_t>(amount - right));
                pair[1] += static_cast<std::uint32_t>(static_cast<std::int32_t>(right));
            };
            std::uint32_t* at = density + corner[i];
            const float back = mass[i] * fw[i];
            const float front = mass[i] - back;
            const float frontTop = front * fv[i];
            const float backTop = back * fv[i];
            add(at, front - frontTop, fu[i]);
            add(at + nu, frontTop, fu[i]);
            add(at + plane, back - backTop, fu[i]);
            add(at + plane + nu, backTop, fu[i]);
        }
    }
}

/// Room for one float for each cell of a line along u, and for a vector past its end.
using LineOfCells = std::array<float, kMaxLightResolution + kAlignment / sizeof(float)>;

/// exp(-depth * scale) * weights, added to the sky and ground of a line of cells, u fastest.
HWY_INLINE void addTransmittance(const float* HWY_RESTRICT depth, std::size_t count, const AmbientDirection& direction, float scale, float* HWY_RESTRICT sky, float* HWY_RESTRICT ground)
{
    const D d;
    const V skyWeight = hn::Set(d, direction.sky);
    const V groundWeight = hn::Set(d, direction.ground);
    const auto through = [&](std::size_t i) HWY_ATTR { return exponential(d, hn::Mul(hn::LoadU(d, depth + i), hn::Set(d, -scale))); };
    std::size_t i = 0;
    for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
        const V light = through(i);
        hn::StoreU(mulAdd(light, skyWeight, hn::LoadU(d, sky + i)), d, sky + i);
        hn::StoreU(mulAdd(light, groundWeight, hn::LoadU(d, ground + i)), d, ground + i);
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
HWY_INLINE void addHalf(const float* HWY_RESTRICT a, const float* HWY_RESTRICT b, std::size_t count, float* HWY_RESTRICT depth)
{
    const D d;
    const V half = hn::Set(d, 0.5F);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const V sum = hn::Add(hn::LoadU(d, a + i), hn::LoadU(d, b + i));
        hn::StoreU(mulAdd(half, sum, hn::LoadU(d, depth + i)), d, depth + i);
    }
}

void ambient(LightGrid& grid, const AmbientDirection& direction, float occlusion, int line)
{
    const auto nu = static_cast<std::size_t>(grid.shape.nu);
    const auto nv = static_cast<std::size_t>(grid.shape.nv);
    const auto nw = static_cast<std::size_t>(grid.shape.nw);
    const float scale = occlusion * grid.shape.cell;
    // Densities are padded by a vector, so that the last line may be read past its end.
    LineOfCells depth{};
    const auto lineOf = [&](std::size_t v, std::size_t w) { return (w * nv + v) * nu; };
    const auto index = static_cast<std::size_t>(line);
    if (direction.axis == 0) {
        for (std::size_t v = 0; v < nv; ++v) {
            const float* density = grid.density.data() + lineOf(v, index);
            float sum = 0.0F;
            for (std::size_t i = 0; i < nu; ++i) {
                const std::size_t u = direction.reversed ? nu - 1 - i : i;
                sum += 0.5F * density[u];
                depth[u] = sum;
                sum += 0.5F * density[u];
            }
            addTransmittance(depth.data(), nu, direction, scale, grid.sky.data() + lineOf(v, index), grid.ground.data() + lineOf(v, index));
        }
        return;
    }
    const std::size_t count = direction.axis == 1 ? nv : nw;
    const auto start = [&](std::size_t i) {
        const std::size_t at = direction.reversed ? count - 1 - i : i;
        return direction.axis == 1 ? lineOf(at, index) : lineOf(index, at);
    };
    for (std::size_t i = 0; i < count; ++i) {
        const float* here = grid.density.data() + start(i);
        addHalf(here, i == 0 ? grid.scratch.data() : grid.density.data() + start(i - 1), nu, depth.data());
        addTransmittance(depth.data(), nu, direction, scale, grid.sky.data() + start(i), grid.ground.data() + start(i));
    }
}

/// Henyey-Greenstein relative to isotropic scattering: (1 - g^2) / (1 + g^2 - 2 g cosine)^(3/2).
HWY_INLINE V phase(D d, float g, V cosine)
{
    const V base = hn::Sub(hn::Set(d, 1.0F + g * g), hn::Mul(hn::Set(d, 2.0F * g), cosine));
    return hn::Div(hn::Set(d, 1.0F - g * g), hn::Mul(base, hn::Sqrt(base)));
}

void sun(LightGrid& grid, const SunJob& job, int row)
{
    const D d;
    const GridShape& shape = grid.shape;
    const auto nu = static_cast<std::size_t>(shape.nu);
    const auto v = static_cast<std::size_t>(row);
    LineOfCells depth{};
    const float scatterSum = 1.0F + job.scattering + job.scattering * job.scattering;
    constexpr float kDeeper = 0.35F; // extinction that each order of scattering still sees, relative to the one before
    for (std::size_t w = 0; w < static_cast<std::size_t>(shape.nw); ++w) {
        const std::size_t at = (w * static_cast<std::size_t>(shape.nv) + v) * nu;
        const float* before = w == 0 ? grid.scratch.data() : grid.density.data() + at - static_cast<std::size_t>(shape.nv) * nu;
        addHalf(grid.density.data() + at, before, nu, depth.data());
        const float dv = job.eye.y - (shape.origin.y + static_cast<float>(v) * shape.cell);
        const float dw = job.eye.z - (shape.origin.z + static_cast<float>(w) * shape.cell);
        for (std::size_t i = 0; i < nu; i += hn::Lanes(d)) {
            const V du = hn::Sub(hn::Set(d, job.eye.x - shape.origin.x), hn::Mul(hn::Add(hn::Iota(d, 0.0F), hn::Set(d, static_cast<float>(i))), hn::Set(d, shape.cell)));
            const V distance = hn::Sqrt(hn::Add(hn::Mul(du, du), hn::Set(d, dv * dv + dw * dw + 1e-12F)));
            const V cosine = hn::Div(hn::Set(d, dw), distance); // light travels along +w; the eye is at (du, dv, dw)
            const V tau = hn::Mul(hn::LoadU(d, depth.data() + i), hn::Set(d, shape.cell * job.shadow));
            V sum = hn::Zero(d);
            float weight = job.intensity / scatterSum;
            float reach = 1.0F;
            float g = job.anisotropy;
            for (int order = 0; order < 3; ++order) {
                const V through = exponential(d, hn::Mul(tau, hn::Set(d, -reach)));
                sum = mulAdd(hn::Mul(hn::Set(d, weight), phase(d, g, cosine)), through, sum);
                weight *= job.scattering;
                reach *= kDeeper;
                g *= 0.5F;
            }
            HWY_ALIGN float bright[HWY_MAX_BYTES / sizeof(float)];
            HWY_ALIGN float taus[HWY_MAX_BYTES / sizeof(float)];
            hn::Store(sum, d, bright);
            hn::Store(tau, d, taus);
            const std::size_t n = std::min(hn::Lanes(d), nu - i);
            for (std::size_t lane = 0; lane < n; ++lane) {
                float* cell = grid.light.data() + (at + i + lane) * 4;
                cell[0] = bright[lane];
                cell[1] = grid.sky[at + i + lane];
                cell[2] = grid.ground[at + i + lane];
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

void splatChunk(const Particles& particles, const Appearance& appearance, const GridShape& shape, float unitsPerMass, std::size_t chunk, std::uint32_t* density)
{
    HWY_DYNAMIC_DISPATCH(splat)
    (particles, appearance, shape, unitsPerMass, chunk, density);
}

void addAmbient(LightGrid& grid, const AmbientDirection& direction, float occlusion, int line)
{
    HWY_DYNAMIC_DISPATCH(ambient)
    (grid, direction, occlusion, line);
}

void addSun(LightGrid& grid, const SunJob& job, int row)
{
    HWY_DYNAMIC_DISPATCH(sun)
    (grid, job, row);
}

} // namespace fumage
#endif
