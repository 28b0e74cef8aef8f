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

    static HWY_INLINE Shape round(D d)
    {
        return {hn::Set(d, 1.0F), hn::Set(d, 1.0F), hn::Set(d, 1.0F), hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    }

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
    return {either(a.xx, b.xx), either(a.yy, b.yy), either(a.zz, b.zz), either(a.xy, b.xy), either(a.xz, b.xz),
        either(a.yz, b.yz)};
}

/// A map by what it makes of the three unit vectors.
struct Map {
    Vec3<V> x, y, z;
};

/// What a flow B in the half of a step maps its start to, by its middle: (1 - B)^-1 (1 + B) = 2 (1 - B)^-1 - 1, which
/// turns what turns without stretching it and keeps volumes to third order.
/// @param b by its columns
HWY_INLINE Map mapOf(const Map& b)
{
    const V x = 1.0F - b.x.x;
    const V y = 1.0F - b.y.y;
    const V z = 1.0F - b.z.z;
    // 1 - B by its cofactors, those of a column side by side.
    const Vec3<V> cofactorsX{y * z - b.y.z * b.z.y, b.z.y * b.x.z + z * b.x.y, b.x.y * b.y.z + b.x.z * y};
    const Vec3<V> cofactorsY{b.y.z * b.z.x + b.y.x * z, z * x - b.z.x * b.x.z, b.x.z * b.y.x + x * b.y.z};
    const Vec3<V> cofactorsZ{b.y.x * b.z.y + y * b.z.x, b.z.x * b.x.y + b.z.y * x, x * y - b.x.y * b.y.x};
    const V volume = x * cofactorsX.x - b.x.y * cofactorsY.x - b.x.z * cofactorsZ.x;
    const V twice = 2.0F / volume;
    Map out{cofactorsX * twice, cofactorsY * twice, cofactorsZ * twice};
    out.x.x = out.x.x - 1.0F;
    out.y.y = out.y.y - 1.0F;
    out.z.z = out.z.z - 1.0F;
    return out;
}

/// A shape after a step: dC/dt = G C + C G^T - (C - 1) / tau, by C' = F C F^T, which stays positive, and then some way
/// back to a ball. Flows that would stretch by more than their own length in a step count as if they did so by as much,
/// so that their map always has an inverse.
/// @param slope     of the air along each axis, m/s a cell
/// @param gradient2 sum of their squares
template <class Time>
HWY_INLINE Shape deformed(
    D d, const StepConstants& constants, const Time& time, const Vec3<V> (&slope)[3], V gradient2, const Shape& shape)
{
    const auto cells = time(constants.dt / constants.air.field->grid.cell);
    const V norm2 = gradient2 * (cells * cells);
    const V half = 0.5F * cells / hn::Sqrt(hn::Max(norm2, hn::Set(d, 1.0F)));
    Map map = mapOf({slope[0] * half, slope[1] * half, slope[2] * half});
    if (constants.rotation != 0.0F) {
        const SineCosine<V> angle = time.rotation(d, constants);
        map = {rotated(angle, map.x), rotated(angle, map.y), rotated(angle, map.z)};
    }
    return shape.mapped(map.x, map.y, map.z).relaxed(constants.air.shapeLost).bounded(d, kMaxDeformation);
}

} // namespace fumage::HWY_NAMESPACE::stepping
HWY_AFTER_NAMESPACE();

#endif
