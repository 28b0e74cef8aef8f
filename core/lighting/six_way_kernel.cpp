#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lighting/six_way_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/lighting/scattering-inl.h"
#include "core/lighting/six_way_kernel.h"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Density between the light and the centre of each cell of one line, the cell before in the light's way being `step`
/// floats away.
void sumFrom(const float* density, std::size_t count, std::ptrdiff_t step, float* depth)
{
    float sum = 0.0F;
    for (std::size_t i = 0; i < count; ++i, density += step, depth += step) {
        sum += 0.5F * *density;
        *depth = sum;
        sum += 0.5F * *density;
    }
}

/// The same for many lines side by side: what lies before is a whole line of cells away.
void sumAcross(const float* HWY_RESTRICT density, std::size_t width, std::size_t count, std::ptrdiff_t step,
    float* HWY_RESTRICT depth)
{
    for (std::size_t u = 0; u < width; ++u) {
        depth[u] = 0.5F * density[u];
    }
    for (std::size_t i = 1; i < count; ++i) {
        const float* HWY_RESTRICT before = density;
        const float* HWY_RESTRICT above = depth;
        density += step;
        depth += step;
        for (std::size_t u = 0; u < width; ++u) {
            depth[u] = above[u] + 0.5F * (before[u] + density[u]);
        }
    }
}

/// Optical depth, but for the size of a cell, towards a light at one end of an axis.
void sumDepths(const LightGrid& grid, int axis, bool fromAbove, float* depth)
{
    const std::array<std::size_t, 3> counts{static_cast<std::size_t>(grid.shape.nu),
        static_cast<std::size_t>(grid.shape.nv), static_cast<std::size_t>(grid.shape.nw)};
    const std::array<std::size_t, 3> strides{1, counts[0], counts[0] * counts[1]};
    const auto along = static_cast<std::size_t>(axis);
    const std::size_t first = fromAbove ? (counts[along] - 1) * strides[along] : 0;
    const auto step = static_cast<std::ptrdiff_t>(strides[along]) * (fromAbove ? -1 : 1);
    if (axis == 0) {
        for (std::size_t line = 0; line < counts[1] * counts[2]; ++line) {
            sumFrom(grid.density.data() + line * counts[0] + first, counts[0], step, depth + line * counts[0] + first);
        }
        return;
    }
    const std::size_t other = axis == 1 ? 2 : 1;
    for (std::size_t line = 0; line < counts[other]; ++line) {
        const std::size_t at = line * strides[other] + first;
        sumAcross(grid.density.data() + at, counts[0], counts[along], step, depth + at);
    }
}

void sunFrom(const LightGrid& grid, const SunJob& job, int axis, bool fromAbove, float* light)
{
    using D = hn::ScalableTag<float>;
    using V = hn::Vec<D>;
    const D d;
    const GridShape& shape = grid.shape;
    const auto nu = static_cast<std::size_t>(shape.nu);
    const float perCell = shape.cell * job.shadow;
    const float travel = fromAbove ? -1.0F : 1.0F;
    sumDepths(grid, axis, fromAbove, light);
    for (int w = 0; w < shape.nw; ++w) {
        for (int v = 0; v < shape.nv; ++v) {
            float* line = light + static_cast<std::size_t>(w * shape.nv + v) * nu;
            const float dv = job.eye.y - (shape.origin.y + static_cast<float>(v) * shape.cell);
            const float dw = job.eye.z - (shape.origin.z + static_cast<float>(w) * shape.cell);
            for (std::size_t i = 0; i < nu; i += hn::Lanes(d)) {
                constexpr float kNeverZero = 1e-12F;
                const V du = (job.eye.x - shape.origin.x) - (hn::Iota(d, 0.0F) + static_cast<float>(i)) * shape.cell;
                const V distance = hn::Sqrt(du * du + (dv * dv + dw * dw + kNeverZero));
                const V toEye = axis == 0 ? du : hn::Set(d, axis == 1 ? dv : dw);
                const V bright = scattered(d, job, hn::LoadU(d, line + i) * perCell, toEye * travel / distance);
                hn::BlendedStore(bright, hn::FirstN(d, nu - i), d, line + i);
            }
        }
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(sunFrom);

void addSunFrom(const LightGrid& grid, const SunJob& job, int axis, bool fromAbove, float* light)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(sunFrom);
    kernel(grid, job, axis, fromAbove, light);
}

} // namespace fumage
#endif
