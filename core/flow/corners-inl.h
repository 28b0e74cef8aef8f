// Included once per SIMD target: values between cells, of four numbers a cell that lie side by side.

#if defined(FUMAGE_CORNERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_CORNERS_INL_H
#undef FUMAGE_CORNERS_INL_H
#else
#define FUMAGE_CORNERS_INL_H
#endif

#include "core/base/vector-inl.h"
#include "core/flow/halves-inl.h"

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
    return loadHalf(d, from);
}

/// What combine(a, b, c, e) makes of the quads on the four rows along x around a place: both ends of each at once where
/// a vector has room for them.
/// @param quad the lowest corner; from its second number on where quads are taken one number at a time, and so on
/// @tparam Number float, or the bits of half floats
template <class Number, class Combine>
HWY_INLINE Ends combinedRows(
    const Number* HWY_RESTRICT quad, std::size_t row, std::size_t plane, const Combine& combine)
{
    const auto rows = [&](auto d, const Number* at) HWY_ATTR {
        return combine(
            numbersAt(d, at), numbersAt(d, at + row), numbersAt(d, at + plane), numbersAt(d, at + plane + row));
    };
#if HWY_MAX_BYTES >= 32
    const auto both = rows(hn::CappedTag<float, 8>(), quad);
    return {hn::LowerHalf(QuadTag(), both), hn::UpperHalf(QuadTag(), both)};
#else
    return {rows(QuadTag(), quad), rows(QuadTag(), quad + 4)};
#endif
}

/// Trilinear in y and z, of the quads on four rows.
template <SimdVector V>
HWY_INLINE V mixedYZ(V a, V b, V c, V e, V y, V z)
{
    return mixed(mixed(a, b, y), mixed(c, e, y), z);
}

/// Trilinear: the four rows first, y before z, then x.
HWY_INLINE QuadVec sampled(const float* HWY_RESTRICT quad, std::size_t row, std::size_t plane, const Between& at)
{
    const Ends ends = combinedRows(quad, row, plane, [&](auto a, auto b, auto c, auto e) HWY_ATTR {
        using V = decltype(a);
        return mixedYZ(a, b, c, e, everyLane<V>(at.y), everyLane<V>(at.z));
    });
    return mixed(ends.low, ends.high, everyLane<QuadVec>(at.x));
}

template <SimdVector V>
HWY_INLINE V leastOf(V a, V b, V c, V e)
{
    return hn::Min(hn::Min(a, b), hn::Min(c, e));
}

template <SimdVector V>
HWY_INLINE V mostOf(V a, V b, V c, V e)
{
    return hn::Max(hn::Max(a, b), hn::Max(c, e));
}

/// Between the least and the most of the eight corners.
HWY_INLINE QuadVec limited(const float* HWY_RESTRICT quad, std::size_t row, std::size_t plane, QuadVec value)
{
    const Ends least =
        combinedRows(quad, row, plane, [](auto a, auto b, auto c, auto e) HWY_ATTR { return leastOf(a, b, c, e); });
    const Ends most =
        combinedRows(quad, row, plane, [](auto a, auto b, auto c, auto e) HWY_ATTR { return mostOf(a, b, c, e); });
    return hn::Min(hn::Max(value, hn::Min(least.low, least.high)), hn::Max(most.low, most.high));
}

#if HWY_MAX_BYTES >= 64
// The same for four places at once whose corners are beside one another along x: all corners of one kind are then one
// vector.

using FourTag = hn::CappedTag<float, 16>;
using FourVec = hn::Vec<FourTag>;

/// Each of four numbers for all numbers of its quad.
HWY_INLINE FourVec eachForQuad(const float* numbers)
{
    const FourTag d;
    HWY_ALIGN static constexpr std::int32_t kQuadOf[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
    return hn::TableLookupLanes(hn::LoadDup128(d, numbers), hn::SetTableIndices(d, kQuadOf));
}

/// What combine(a, b, c, e) makes of the four rows, at one end.
template <class Combine>
HWY_INLINE FourVec combinedFours(
    const float* HWY_RESTRICT quad, std::size_t row, std::size_t plane, const Combine& combine)
{
    const FourTag d;
    return combine(
        hn::LoadU(d, quad), hn::LoadU(d, quad + row), hn::LoadU(d, quad + plane), hn::LoadU(d, quad + plane + row));
}

/// @param x,y,z where the four places are among their corners
HWY_INLINE FourVec sampledFour(
    const float* HWY_RESTRICT quad, std::size_t row, std::size_t plane, const float* x, const float* y, const float* z)
{
    const FourVec atY = eachForQuad(y);
    const FourVec atZ = eachForQuad(z);
    const auto mixedRows = [&](FourVec a, FourVec b, FourVec c, FourVec e)
                               HWY_ATTR { return mixedYZ(a, b, c, e, atY, atZ); };
    return mixed(
        combinedFours(quad, row, plane, mixedRows), combinedFours(quad + 4, row, plane, mixedRows), eachForQuad(x));
}

HWY_INLINE FourVec limitedFour(const float* HWY_RESTRICT quad, std::size_t row, std::size_t plane, FourVec value)
{
    const auto least = [](FourVec a, FourVec b, FourVec c, FourVec e) HWY_ATTR { return leastOf(a, b, c, e); };
    const auto most = [](FourVec a, FourVec b, FourVec c, FourVec e) HWY_ATTR { return mostOf(a, b, c, e); };
    const FourVec low = hn::Min(combinedFours(quad, row, plane, least), combinedFours(quad + 4, row, plane, least));
    const FourVec high = hn::Max(combinedFours(quad, row, plane, most), combinedFours(quad + 4, row, plane, most));
    return hn::Min(hn::Max(value, low), high);
}
#endif

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
