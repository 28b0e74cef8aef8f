// Included once per SIMD target: how the air that carries particles deforms them.

#if defined(FUMAGE_SHAPE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_SHAPE_INL_H
#undef FUMAGE_SHAPE_INL_H
#else
#define FUMAGE_SHAPE_INL_H
#endif

#include "core/simulation/moving-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE::stepping {

template <class M>
HWY_INLINE Vec3<V> chosen(M where, const Vec3<V>& a, const Vec3<V>& b)
{
    return {hn::IfThenElse(where, a.x, b.x), hn::IfThenElse(where, a.y, b.y), hn::IfThenElse(where, a.z, b.z)};
}

/// The squares of particles' axes: a symmetric tensor, 1 for a ball.
struct Shape {
    V xx, yy, zz, xy, xz, yz;

    static HWY_INLINE Shape round(D d) { return {hn::Set(d, 1.0F), hn::Set(d, 1.0F), hn::Set(d, 1.0F), hn::Zero(d), hn::Zero(d), hn::Zero(d)}; }

    static HWY_INLINE Shape from(D d, const Particles& p, std::size_t i)
    {
        const auto at = [&](const AlignedArray<float>& column) HWY_ATTR { return hn::Load(d, column.data() + i); };
        return {at(p.shapeXX), at(p.shapeYY), at(p.shapeZZ), at(p.shapeXY), at(p.shapeXZ), at(p.shapeYZ)};
    }

    HWY_INLINE void to(D d, Particles& p, std::size_t i) const
    {
        const auto put = [&](V value, AlignedArray<float>& column) HWY_ATTR { hn::Store(value, d, column.data() + i); };
        put(xx, p.shapeXX);
        put(yy, p.shapeYY);
        put(zz, p.shapeZZ);
        put(xy, p.shapeXY);
        put(xz, p.shapeXZ);
        put(yz, p.shapeYZ);
    }

    /// F C F^T of a map by its columns.
    [[nodiscard]] HWY_INLINE Shape mapped(const Vec3<V>& x, const Vec3<V>& y, const Vec3<V>& z) const
    {
        const Vec3<V> a = xx * x + xy * y + xz * z;
        const Vec3<V> b = xy * x + yy * y + yz * z;
        const Vec3<V> c = xz * x + yz * y + zz * z;
        return {a.x * x.x + b.x * y.x + c.x * z.x, a.y * x.y + b.y * y.y + c.y * z.y, a.z * x.z + b.z * y.z + c.z * z.z,
            a.x * x.y + b.x * y.y + c.x * z.y, a.x * x.z + b.x * y.z + c.x * z.z, a.y * x.z + b.y * y.z + c.y * z.z};
    }

    /// Back towards a ball by a share of what it differs.
    [[nodiscard]] HWY_INLINE Shape relaxed(float share) const
    {
        const float kept = 1.0F - share;
        return {kept * xx + share, kept * yy + share, kept * zz + share, kept * xy, kept * xz, kept * yz};
    }

    /// No axis longer than a bound, whose square the sum of all squares is kept below.
    [[nodiscard]] HWY_INLINE Shape bounded(D d, float axis) const
    {
        const V scale = hn::Min(hn::Set(d, 1.0F), axis * axis / (xx + yy + zz));
        return {xx * scale, yy * scale, zz * scale, xy * scale, xz * scale, yz * scale};
    }
};

template <class M>
HWY_INLINE Shape chosen(M where, const Shape& a, const Shape& b)
{
    const auto either = [&](V x, V y) HWY_ATTR { return hn::IfThenElse(where, x, y); };
    return {either(a.xx, b.xx), either(a.yy, b.yy), either(a.zz, b.zz), either(a.xy, b.xy), either(a.xz, b.xz), either(a.yz, b.yz)};
}

/// A map by what it makes of the three unit vectors.
struct Map {
    Vec3<V> x, y, z;
};

/// What a flow of these slopes maps a step's start to, by its middle: (1 - A/2)^-1 (1 + A/2), which turns what turns without stretching it and keeps
/// volumes to third order. Flows that would stretch by more than their own length in a step count as if they did so by as much, so that there
/// always is an inverse.
HWY_INLINE Map mapOf(D d, const Map& slopes)
{
    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0F);
    const V norm2 = dot(slopes.x, slopes.x) + dot(slopes.y, slopes.y) + dot(slopes.z, slopes.z);
    const V half = 0.5F / hn::Sqrt(hn::Max(norm2, one));
    const Map by{slopes.x * half, slopes.y * half, slopes.z * half};
    const Vec3<V> ex{one, zero, zero};
    const Vec3<V> ey{zero, one, zero};
    const Vec3<V> ez{zero, zero, one};
    const Map back{ex - by.x, ey - by.y, ez - by.z};
    const Vec3<V> rowX = cross(back.y, back.z);
    const Vec3<V> rowY = cross(back.z, back.x);
    const Vec3<V> rowZ = cross(back.x, back.y);
    const V perVolume = 1.0F / dot(back.x, rowX);
    const auto mapped = [&](const Vec3<V>& v) HWY_ATTR { return Vec3<V>{dot(rowX, v), dot(rowY, v), dot(rowZ, v)} * perVolume; };
    return {mapped(ex + by.x), mapped(ey + by.y), mapped(ez + by.z)};
}

/// A shape after a step: dC/dt = G C + C G^T - (C - 1) / tau, by C' = F C F^T, which stays positive, and then some way back to a ball.
/// @param slope of the air along each axis, m/s a cell
template <class Time>
HWY_INLINE Shape deformed(D d, const StepConstants& constants, const Time& time, const Vec3<V> (&slope)[3], const Shape& shape)
{
    const auto cells = time(constants.dt / constants.air.field->grid.cell);
    Map map = mapOf(d, {slope[0] * cells, slope[1] * cells, slope[2] * cells});
    if (constants.rotation != 0.0F) {
        const SineCosine<V> angle = time.rotation(d, constants);
        map = {rotated(angle, map.x), rotated(angle, map.y), rotated(angle, map.z)};
    }
    return shape.mapped(map.x, map.y, map.z).relaxed(constants.air.shapeLost).bounded(d, kMostDeformation);
}

} // namespace fumage::HWY_NAMESPACE::stepping
HWY_AFTER_NAMESPACE();

#endif
