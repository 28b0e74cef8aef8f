// Included once per SIMD target: the air at the places of particles, one a lane.

#if defined(FUMAGE_FIELD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_FIELD_INL_H
#undef FUMAGE_FIELD_INL_H
#else
#define FUMAGE_FIELD_INL_H
#endif

#include "core/flow/corners-inl.h"
#include "core/flow/field.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Velocity, heat, and how the velocity changes along x, y and z, a cell.
template <SimdVector V>
struct AirThere {
    Vec3<V> velocity;
    V heat;
    Vec3<V> slope[3];
};

/// The quads of a lane, or of each of its three slopes.
struct LaneQuads {
    static constexpr std::size_t kLanes = 16;
    HWY_ALIGN float quad[4 * kLanes];

    HWY_INLINE void put(std::size_t at, QuadVec value) { hn::StoreU(value, QuadTag(), quad + at); }

    template <class D, class V = hn::VFromD<D>>
    HWY_INLINE V take(D d, Vec3<V>& out) const
    {
        V fourth;
        hn::LoadInterleaved4(d, quad, out.x, out.y, out.z, fourth);
        return fourth;
    }
};

/// The air at places, in metres. Outside the box the velocity goes over into the wind within its reach, so that smoke which leaves does not
/// stop at the border.
/// @param reach m
template <bool kSlopes, class D, class V = hn::VFromD<D>>
HWY_INLINE AirThere<V> airAt(D d, const AirField& field, float reach, const Vec3<V>& place)
{
    const hn::RebindToSigned<D> di;
    const glm::vec3 end(field.grid.cells);
    const Vec3<V> cells = (place - field.grid.corner) * (1.0F / field.grid.cell);
    const auto within = [&](V p, float last) HWY_ATTR { return hn::Min(hn::Max(p, hn::Zero(d)), hn::Set(d, last)); };
    const Vec3<V> inside{within(cells.x, end.x), within(cells.y, end.y), within(cells.z, end.z)};
    const auto lowOf = [&](V p, float last) HWY_ATTR { return hn::Min(hn::Floor(p), hn::Set(d, last - 1.0F)); };
    const Vec3<V> low{lowOf(inside.x, end.x), lowOf(inside.y, end.y), lowOf(inside.z, end.z)};
    HWY_ALIGN std::int32_t node[LaneQuads::kLanes];
    HWY_ALIGN float rest[3][LaneQuads::kLanes];
    const auto whole = [&](V number) HWY_ATTR { return hn::ConvertTo(di, number); };
    hn::Store(whole(low.x) * 4 + whole(low.y) * static_cast<std::int32_t>(field.row) + whole(low.z) * static_cast<std::int32_t>(field.plane), di, node);
    float* restX = rest[0];
    float* restY = rest[1];
    float* restZ = rest[2];
    store(inside - low, restX, restY, restZ, 0);

    LaneQuads values;
    LaneQuads slopes[3];
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
        for (std::size_t part = 0; part < 4; part += hn::Lanes(QuadTag())) {
            const std::uint16_t* quad = field.quads.data() + node[lane] + part;
            const QuadVec x = everyLane<QuadVec>(restX[lane]);
            const auto mixedYZ = [&](auto a, auto b, auto c, auto e) HWY_ATTR {
                using W = decltype(a);
                const W y = everyLane<W>(restY[lane]);
                return mixed(mixed(a, b, y), mixed(c, e, y), everyLane<W>(restZ[lane]));
            };
            const Ends ends = combinedRows(quad, field.row, field.plane, mixedYZ);
            values.put(4 * lane + part, mixed(ends.low, ends.high, x));
            if constexpr (kSlopes) {
                const Ends alongY = combinedRows(quad, field.row, field.plane, [&](auto a, auto b, auto c, auto e) HWY_ATTR { return mixed(b - a, e - c, everyLane<decltype(a)>(restZ[lane])); });
                const Ends alongZ = combinedRows(quad, field.row, field.plane, [&](auto a, auto b, auto c, auto e) HWY_ATTR { return mixed(c - a, e - b, everyLane<decltype(a)>(restY[lane])); });
                slopes[0].put(4 * lane + part, ends.high - ends.low);
                slopes[1].put(4 * lane + part, mixed(alongY.low, alongY.high, x));
                slopes[2].put(4 * lane + part, mixed(alongZ.low, alongZ.high, x));
            }
        }
    }

    const Vec3<V> outside = cells - inside;
    const V beyond = hn::Sqrt(dot(outside, outside)) * (field.grid.cell / reach);
    const V near = hn::Max(hn::Zero(d), 1.0F - beyond);
    const V fade = near * near;
    AirThere<V> there;
    there.heat = values.take(d, there.velocity) * fade;
    const Vec3<V> wind = broadcast(d, field.wind);
    there.velocity = wind + (there.velocity - wind) * fade;
    if constexpr (kSlopes) {
        for (int axis = 0; axis < 3; ++axis) {
            (void)slopes[axis].take(d, there.slope[axis]);
            there.slope[axis] = there.slope[axis] * fade;
        }
    }
    return there;
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
