// Included once per SIMD target: reads light between the cells of a grid.

#if defined(FUMAGE_LIGHT_LOOKUP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_LIGHT_LOOKUP_INL_H
#undef FUMAGE_LIGHT_LOOKUP_INL_H
#else
#define FUMAGE_LIGHT_LOOKUP_INL_H
#endif

#include "core/rendering/sprite_kernel.h"

#include <cstring>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

HWY_INLINE Float4 load4(const float* from)
{
    Float4 out;
    std::memcpy(&out, from, sizeof(out));
    return out;
}

HWY_INLINE Float4 mix4(Float4 a, Float4 b, float t)
{
    return (b - a) * t + a;
}

/// Trilinear interpolation of four channels.
/// @param cells four floats a cell @param corner the lowest of the eight cells around the place @param u,v,w way from its centre to the next
HWY_INLINE Float4 trilinear(const GridShape& shape, const float* cells, std::int32_t corner, float u, float v, float w)
{
    const std::size_t du = shape.nu > 1 ? 4 : 0;
    const std::size_t dv = shape.nv > 1 ? static_cast<std::size_t>(shape.nu) * 4 : 0;
    const std::size_t dw = shape.nw > 1 ? static_cast<std::size_t>(shape.nu) * static_cast<std::size_t>(shape.nv) * 4 : 0;
    const float* at = cells + static_cast<std::size_t>(corner) * 4;
    const auto line = [&](const float* from) { return mix4(load4(from), load4(from + du), u); };
    const Float4 front = mix4(line(at), line(at + dv), v);
    const Float4 back = mix4(line(at + dw), line(at + dw + dv), v);
    return mix4(front, back, w);
}

/// The same of one channel.
HWY_INLINE float trilinearOne(const GridShape& shape, const float* cells, std::int32_t corner, float u, float v, float w)
{
    const std::size_t du = shape.nu > 1 ? 1 : 0;
    const std::size_t dv = shape.nv > 1 ? static_cast<std::size_t>(shape.nu) : 0;
    const std::size_t dw = shape.nw > 1 ? static_cast<std::size_t>(shape.nu) * static_cast<std::size_t>(shape.nv) : 0;
    const float* at = cells + corner;
    const auto mix = [](float a, float b, float t) { return (b - a) * t + a; };
    const auto line = [&](const float* from) { return mix(from[0], from[du], u); };
    return mix(mix(line(at), line(at + dv), v), mix(line(at + dw), line(at + dw + dv), v), w);
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
