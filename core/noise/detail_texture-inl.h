// Included once per SIMD target: reads the texels of detail, one a lane.

#if defined(FUMAGE_DETAIL_TEXTURE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_DETAIL_TEXTURE_INL_H
#undef FUMAGE_DETAIL_TEXTURE_INL_H
#else
#define FUMAGE_DETAIL_TEXTURE_INL_H
#endif

#include "core/base/vector-inl.h"
#include "core/noise/detail_texture.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Bits after the point of fixed-point texel coordinates.
constexpr int kTexelFractionBits = 7;

/// log2 of a level's edge.
HWY_INLINE int edgeBits(int level)
{
    return std::countr_zero(static_cast<unsigned>(DetailTexture::size(level)));
}

/// DetailTexture::indexOf() of fixed-point coordinates, which repeat: their bits, moved to where they belong.
/// @param edge see edgeBits()
template <SimdVector I>
HWY_INLINE I texelIndex(int edge, I x, I y, I z)
{
    using T = DetailTexture;
    static_assert(T::kBrickX == 2 && T::kBrickY == 1 && T::kBrickZ == 1);
    // What the shifts ask for.
    static_assert(T::size(0) >= 16);
    static_assert(T::size(T::kLevels - 1) <= 1 << kTexelFractionBits);
    constexpr int kFraction = kTexelFractionBits;
    constexpr int kBits = T::kBrickX + T::kBrickY + T::kBrickZ;
    const auto bits = [&](int count, int at) HWY_ATTR { return everyLane<I>(((1 << count) - 1) << at); };
    const I inX = hn::And(hn::ShiftRight<kFraction>(x), bits(T::kBrickX, 0));
    const I inY = hn::And(hn::ShiftRight<kFraction - T::kBrickX>(y), bits(T::kBrickY, T::kBrickX));
    const I inZ =
        hn::And(hn::ShiftRight<kFraction - T::kBrickX - T::kBrickY>(z), bits(T::kBrickZ, T::kBrickX + T::kBrickY));
    const I brickX = hn::And(hn::ShiftRight<kFraction + T::kBrickX - kBits>(x), bits(edge - T::kBrickX, kBits));
    // By edge - 6 and 2 edge - 7 bits to the left, edge being 4 to 7.
    const I brickY =
        hn::And(hn::ShiftRightSame(hn::ShiftLeft<1>(y), kFraction - edge), bits(edge - T::kBrickY, edge + 2));
    const I brickZ = hn::And(hn::ShiftLeftSame(z, 2 * edge - kFraction), bits(edge - T::kBrickZ, 2 * edge + 1));
    return hn::Or(hn::Or(hn::Or(inX, brickX), hn::Or(inY, brickY)), hn::Or(inZ, brickZ));
}

/// The vector form of DetailTexture::Sample.
template <SimdVector V>
struct DetailSamples {
    V value;
    Vec3<V> slope;
};

/// @param texels where, in texels of the level
template <class D, class V = hn::VFromD<D>>
HWY_INLINE DetailSamples<V> samplesAt(D d, const DetailTexture& texture, int level, const Vec3<V>& texels)
{
    const hn::RebindToSigned<D> di;
    const Vec3<V> whole{hn::Floor(texels.x), hn::Floor(texels.y), hn::Floor(texels.z)};
    const Vec3<V> part = texels - whole;
    const auto fixed = [&](V along) HWY_ATTR { return hn::ShiftLeft<kTexelFractionBits>(hn::ConvertTo(di, along)); };
    const auto index = texelIndex(edgeBits(level), fixed(whole.x), fixed(whole.y), fixed(whole.z));
    const auto numbers = hn::GatherIndex(di, reinterpret_cast<const std::int32_t*>(texture.texels(level)), index);
    const auto number = [&](auto byteOnTop) HWY_ATTR { return hn::ConvertTo(d, hn::ShiftRight<24>(byteOnTop)); };
    const Vec3<V> slope{number(hn::ShiftLeft<16>(numbers)), number(hn::ShiftLeft<8>(numbers)), number(numbers)};
    const V sum = number(hn::ShiftLeft<24>(numbers)) + part.x * slope.x + part.y * slope.y + part.z * slope.z;
    constexpr float kToOne = 1.0F / static_cast<float>(DetailTexture::kFull);
    return {sum * kToOne, slope * kToOne};
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
