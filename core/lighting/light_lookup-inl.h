// Included once per SIMD target: reads light between the cells of a grid.

#if defined(FUMAGE_LIGHT_LOOKUP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_LIGHT_LOOKUP_INL_H
#undef FUMAGE_LIGHT_LOOKUP_INL_H
#else
#define FUMAGE_LIGHT_LOOKUP_INL_H
#endif

#include "core/base/float4.h"
#include "core/lighting/light_field.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Trilinear interpolation of the channels of a cell.
/// @tparam Value float, or Float4 for four floats a cell
/// @param corner the lowest of the eight cells around the place @param u,v,w way from its centre to the next
template <class Value>
HWY_INLINE Value trilinear(const GridShape& shape, const float* cells, std::int32_t corner, float u, float v, float w)
{
    constexpr std::size_t kChannels = sizeof(Value) / sizeof(float);
    const std::size_t du = shape.nu > 1 ? kChannels : 0;
    const std::size_t dv = shape.nv > 1 ? static_cast<std::size_t>(shape.nu) * kChannels : 0;
    const std::size_t dw =
        shape.nw > 1 ? static_cast<std::size_t>(shape.nu) * static_cast<std::size_t>(shape.nv) * kChannels : 0;
    const float* at = cells + static_cast<std::size_t>(corner) * kChannels;
    const auto mix = [](Value a, Value b, float t) { return (b - a) * t + a; };
    const auto line = [&](const float* from) { return mix(loadFloats<Value>(from), loadFloats<Value>(from + du), u); };
    const Value front = mix(line(at), line(at + dv), v);
    const Value back = mix(line(at + dw), line(at + dw + dv), v);
    return mix(front, back, w);
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
