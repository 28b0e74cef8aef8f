// Included once per SIMD target: where points lie in rotated axes and in a grid.

#if defined(FUMAGE_GRID_CELL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_GRID_CELL_INL_H
#undef FUMAGE_GRID_CELL_INL_H
#else
#define FUMAGE_GRID_CELL_INL_H
#endif

#include "core/base/vector-inl.h"
#include "core/lighting/light_field.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Coordinates of points along each of the axes.
template <SimdVector V>
HWY_INLINE Vec3<V> inAxes(const Axes& axes, const Vec3<V>& point)
{
    return {dot(point, axes.u), dot(point, axes.v), dot(point, axes.w)};
}

/// The eight cells whose centres are around a point.
template <class D>
struct GridCell {
    hn::VFromD<hn::RebindToSigned<D>> corner; ///< index of the lowest of them
    Vec3<hn::VFromD<D>> fraction; ///< way from its centre towards the next along u, v and w, in [0, 1)
};

/// Points beyond the outermost centres count as lying on them, wherever they are.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE GridCell<D> gridCellAt(D d, const GridShape& shape, const Vec3<V>& point)
{
    const hn::RebindToSigned<D> di;
    const float perCell = 1.0F / shape.cell;
    const Vec3<V> place = inAxes(shape.axes, point) - shape.origin;
    const auto inside = [&](V along, int count) HWY_ATTR {
        constexpr float kUpperAndABit = 1.001F; // so that the last cell is never the lower one of two
        const float last = std::max(0.0F, static_cast<float>(count) - kUpperAndABit);
        return hn::Min(hn::Max(along * perCell, hn::Zero(d)), hn::Set(d, last));
    };
    const Vec3<V> cells{inside(place.x, shape.nu), inside(place.y, shape.nv), inside(place.z, shape.nw)};
    const Vec3<V> whole{hn::Floor(cells.x), hn::Floor(cells.y), hn::Floor(cells.z)};
    const auto row = hn::ConvertTo(di, whole.z) * shape.nv + hn::ConvertTo(di, whole.y);
    return {row * shape.nu + hn::ConvertTo(di, whole.x), cells - whole};
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
