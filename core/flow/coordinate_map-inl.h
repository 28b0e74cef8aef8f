// Included once per SIMD target: reads coordinates that the air has carried, at a place a lane.

#if defined(FUMAGE_COORDINATE_MAP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_COORDINATE_MAP_INL_H
#undef FUMAGE_COORDINATE_MAP_INL_H
#else
#define FUMAGE_COORDINATE_MAP_INL_H
#endif

#include "core/base/vector-inl.h"
#include "core/flow/coordinate_map.h"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// The vector form of AdvectedPlace.
template <SimdVector V>
struct AdvectedPlaces {
    Vec3<V> place;
    Vec3<V> alongX, alongY, alongZ; ///< its change along the axes
};

/// A slope times a vector that is the same in every lane.
template <SimdVector V>
HWY_INLINE Vec3<V> along(const AdvectedPlaces<V>& of, const glm::vec3& way)
{
    return of.alongX * everyLane<V>(way.x) + of.alongY * everyLane<V>(way.y) + of.alongZ * everyLane<V>(way.z);
}

/// Where places lie along one axis of a map.
template <class D>
struct AlongAxis {
    using V = hn::VFromD<D>;
    V inside; ///< cells from the corner of the grid, in the box
    V beyond; ///< m outside the box
    V share; ///< of the way from the node before to the one after
    hn::VFromD<hn::RebindToSigned<D>> node;

    HWY_INLINE AlongAxis(D d, V place, float corner, float cell, int cells)
    {
        const V at = hn::Div(place - corner, hn::Set(d, cell));
        inside = hn::Min(hn::Max(at, hn::Zero(d)), hn::Set(d, static_cast<float>(cells)));
        beyond = (at - inside) * cell;
        const V low = hn::Min(hn::Floor(inside), hn::Set(d, static_cast<float>(cells - 1)));
        share = inside - low;
        node = hn::ConvertTo(hn::RebindToSigned<D>(), low);
    }
};

/// @param place m; wherever it is, nothing outside the map is read
template <class D, class V = hn::VFromD<D>>
HWY_INLINE AdvectedPlaces<V> advectedPlaces(D d, const CoordinateMap& map, const Vec3<V>& place)
{
    const AirGrid& grid = map.grid;
    const AlongAxis<D> x(d, place.x, grid.corner.x, grid.cell, grid.cells.x);
    const AlongAxis<D> y(d, place.y, grid.corner.y, grid.cell, grid.cells.y);
    const AlongAxis<D> z(d, place.z, grid.corner.z, grid.cell, grid.cells.z);
    const auto quad =
        x.node * 4 + y.node * static_cast<std::int32_t>(map.row) + z.node * static_cast<std::int32_t>(map.plane);
    const auto mix = [](V a, V b, V share) HWY_ATTR { return a + (b - a) * share; };
    const V perMetre = hn::Set(d, 1.0F / grid.cell);
    // One component: its value, and what it grows by along the axes.
    const auto component = [&](std::size_t which, V beyond) HWY_ATTR {
        const float* from = map.quads.data() + which;
        const auto node = [&](std::size_t offset) HWY_ATTR { return hn::GatherIndex(d, from + offset, quad); };
        const V a0 = node(0);
        const V a1 = node(4);
        const V b0 = node(map.row);
        const V b1 = node(map.row + 4);
        const V c0 = node(map.plane);
        const V c1 = node(map.plane + 4);
        const V e0 = node(map.plane + map.row);
        const V e1 = node(map.plane + map.row + 4);
        const V alongX = mix(mix(a1 - a0, b1 - b0, y.share), mix(c1 - c0, e1 - e0, y.share), z.share);
        const V a = mix(a0, a1, x.share);
        const V b = mix(b0, b1, x.share);
        const V c = mix(c0, c1, x.share);
        const V e = mix(e0, e1, x.share);
        const V front = mix(a, b, y.share);
        const V back = mix(c, e, y.share);
        const V alongY = mix(b - a, e - c, z.share);
        return std::array<V, 4>{
            mix(front, back, z.share) + beyond, alongX * perMetre, alongY * perMetre, (back - front) * perMetre};
    };
    const auto [px, xx, xy, xz] = component(0, x.beyond);
    const auto [py, yx, yy, yz] = component(1, y.beyond);
    const auto [pz, zx, zy, zz] = component(2, z.beyond);
    return {{px, py, pz}, {xx, yx, zx}, {xy, yy, zy}, {xz, yz, zz}};
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
