// Included once per SIMD target: arithmetic of vectors with plain numbers, so that a kernel reads like its formula.
// Highway has the operators for two vectors. a * b + c rounds twice whatever it is written with: the build fuses
// nothing (-ffp-contract=off).

#if defined(FUMAGE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_LANES_INL_H
#undef FUMAGE_LANES_INL_H
#else
#define FUMAGE_LANES_INL_H
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A vector of the instruction set, of floats or whole numbers.
template <class V>
concept SimdVector = requires
{
    typename hn::TFromV<V>;
};

/// A number in every lane.
template <SimdVector V>
HWY_INLINE V everyLane(hn::TFromV<V> number)
{
    return hn::Set(hn::DFromV<V>(), number);
}

template <SimdVector V>
HWY_INLINE V operator+(V a, hn::TFromV<V> b)
{
    return hn::Add(a, everyLane<V>(b));
}

template <SimdVector V>
HWY_INLINE V operator+(hn::TFromV<V> a, V b)
{
    return hn::Add(everyLane<V>(a), b);
}

template <SimdVector V>
HWY_INLINE V operator-(V a, hn::TFromV<V> b)
{
    return hn::Sub(a, everyLane<V>(b));
}

template <SimdVector V>
HWY_INLINE V operator-(hn::TFromV<V> a, V b)
{
    return hn::Sub(everyLane<V>(a), b);
}

template <SimdVector V>
HWY_INLINE V operator*(V a, hn::TFromV<V> b)
{
    return hn::Mul(a, everyLane<V>(b));
}

template <SimdVector V>
HWY_INLINE V operator*(hn::TFromV<V> a, V b)
{
    return hn::Mul(everyLane<V>(a), b);
}

template <SimdVector V>
HWY_INLINE V operator/(hn::TFromV<V> a, V b)
{
    return hn::Div(everyLane<V>(a), b);
}

template <SimdVector V>
HWY_INLINE V operator&(V a, hn::TFromV<V> b)
{
    return hn::And(a, everyLane<V>(b));
}

template <SimdVector V>
HWY_INLINE V operator^(V a, hn::TFromV<V> b)
{
    return hn::Xor(a, everyLane<V>(b));
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
