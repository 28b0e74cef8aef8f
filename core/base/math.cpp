#include "core/base/math.h"

#include "core/base/math-inl.h"

// What the instruction set of the kernels needs, NEON's for instance, is asked for here too.
HWY_BEFORE_NAMESPACE();
namespace fumage {

namespace {

namespace hn = hwy::HWY_NAMESPACE;
using OneLane = hn::CappedTag<float, 1>;

} // namespace

float portableSin(float angle)
{
    const OneLane d;
    return hn::GetLane(HWY_NAMESPACE::sinCos(d, hn::Set(d, angle)).sine);
}

float portableCos(float angle)
{
    const OneLane d;
    return hn::GetLane(HWY_NAMESPACE::sinCos(d, hn::Set(d, angle)).cosine);
}

float portableExp(float x)
{
    const OneLane d;
    return hn::GetLane(HWY_NAMESPACE::exponential(d, hn::Set(d, x)));
}

float portableLog(float x)
{
    const OneLane d;
    return hn::GetLane(HWY_NAMESPACE::logarithm(d, hn::Set(d, x)));
}

float portablePow(float x, float y)
{
    if (y == 0.0F) {
        return 1.0F;
    }
    return x <= 0.0F ? 0.0F : portableExp(y * portableLog(x));
}

} // namespace fumage
HWY_AFTER_NAMESPACE();
