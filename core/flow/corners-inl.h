// Included once per SIMD target: values between cells, of four numbers a cell that lie side by side.

#if defined(FUMAGE_CORNERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_CORNERS_INL_H
#undef FUMAGE_CORNERS_INL_H
#else
#define FUMAGE_CORNERS_INL_H
#endif

#include "core/base/vector-inl.h"
#include "core/flow/halfs-inl.h"

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Four numbers, or as many of them as a vector has lanes. Machines without vectors go through them one by one.
using QuadTag = hn::CappedTag<float, 4>;
using QuadVec = hn::Vec<QuadTag>;
/// The place of a cell among eight: how far beyond the lowest corner, in cells, 0 to 1.
struct Between {
    float x, y, z;
};

template <SimdVector V>
HWY_INLINE V mixed(V a, V b, V share)
{
    return a + share * (b - a);
}

/// The quads of two cells of equal y and z.
struct Ends {
    QuadVec low, high;
};

/// Numbers side by side, as they are or from half floats.
template <class D>
HWY_INLINE hn::VFromD<D> numbersAt(D d, const float* from)
{
    return hn::LoadU(d, from);
}
template <class D>
HWY_INLINE hn::VFromD<D> numbersAt(D d, const std::uint16_t* from)
{
    return loadHalfs(d, from);
}

/// What combine(a, b, c, e) makes of the quads on the four rows along x around a place: both ends of each at once where a vector has room for them.
/// @param quad the lowest corner; from its second number on where quads are taken one number at a time, and so on
/// @tparam Number float, or the bits of half floats
template <class Number, class Combine>
HWY_INLINE Ends combinedRows(const Number* HWY_RESTRICT quad, std::size_t row, std::size_t plane, const Combine& combine)
{
    const auto rows = [&](auto d, const Number* at) HWY_ATTR { return combine(numbersAt(d, at), numbersAt(d, at + row), numbersAt(d, at + plane), numbersAt(d, at + plane + row)); };
#if HWY_MAX_BYTES >= 32
    const auto both = rows(hn::CappedTag<float, 8>(), quad);
    return {hn::LowerHalf(QuadTag(), both), hn::UpperHalf(QuadTag(), both)};
#else
    return {rows(QuadTag(), quad), rows(QuadTag(), quad + 4)};
#endif
}

/// Trilinear: the four rows first, y before z, then x.
HWY_INLINE QuadVec sampled(const float* HWY_RESTRICT quad, std::size_t row, std::size_t plane, const Between& at)
{
    const Ends ends = combinedRows(quad, row, plane, [&](auto a, auto b, auto c, auto e) HWY_ATTR {
        using V = decltype(a);
        const V y = everyLane<V>(at.y);
        return mixed(mixed(a, b, y), mixed(c, e, y), everyLane<V>(at.z));
    });
    return mixed(ends.low, ends.high, everyLane<QuadVec>(at.x));
}

/// Between the least and the most of the eight corners.
HWY_INLINE QuadVec limited(const float* HWY_RESTRICT quad, std::size_t row, std::size_t plane, QuadVec value)
{
    const Ends least = combinedRows(quad, row, plane, [](auto a, auto b, auto c, auto e) HWY_ATTR { return hn::Min(hn::Min(a, b), hn::Min(c, e)); });
    const Ends most = combinedRows(quad, row, plane, [](auto a, auto b, auto c, auto e) HWY_ATTR { return hn::Max(hn::Max(a, b), hn::Max(c, e)); });
    return hn::Min(hn::Max(value, hn::Min(least.low, least.high)), hn::Max(most.low, most.high));
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
