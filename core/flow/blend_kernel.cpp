#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/flow/blend_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/flow/blend_kernel.h"
#include "core/flow/grid.h"
#include "core/flow/halves-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

void blend(const AirField& a, const AirField& b, float share, AirField& out)
{
    const hn::CappedTag<float, kAirLanes> d;
    for (std::size_t i = 0; i < out.quads.size(); i += hn::Lanes(d)) {
        const auto from = loadHalf(d, a.quads.data() + i);
        const auto to = loadHalf(d, b.quads.data() + i);
        storeHalf(from + share * (to - from), out.quads.data() + i);
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(blend);

void blendFields(const AirField& a, const AirField& b, float share, AirField& out)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(blend);
    kernel(a, b, share, out);
}

} // namespace fumage
#endif
