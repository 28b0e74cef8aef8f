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

/// Where the lanes' places are among the nodes.
template <SimdVector V>
struct LanePlaces {
    HWY_ALIGN std::int32_t node[hn::MaxLanes(hn::DFromV<V>())]; ///< halves from the first node to the lowest corner
    Vec3<V> beyond; ///< how far beyond it, in cells
    V outside2; ///< square of how far outside the box, in cells
};

#if HWY_MAX_BYTES >= 64
// All lanes at once, four to a vector, whose blocks of four numbers are the quads of lanes n, n + 4, n + 8 and n + 12:
// four such vectors are transposed within their blocks, and what lanes have of their own is broadcast within them,
// which costs least.

/// Both ends of a row of nodes.
struct FourEnds {
    FourVec low, high;
};

/// @param row  the row around lanes whose lowest corner is node 0
/// @param node of the first of the four lanes
HWY_INLINE FourEnds endsOf(const std::uint16_t* HWY_RESTRICT row, const std::int32_t* HWY_RESTRICT node)
{
    const hn::CappedTag<std::uint16_t, 8> ends;
    const hn::CappedTag<std::uint64_t, 4> quads;
    const auto ofTwo = [&](std::size_t lane) HWY_ATTR {
        return hn::BitCast(quads,
            hn::Combine(
                hn::Twice<decltype(ends)>(), hn::LoadU(ends, row + node[lane + 8]), hn::LoadU(ends, row + node[lane])));
    };
    const auto numbers = [](auto halves) HWY_ATTR {
        return hn::PromoteTo(FourTag(), hn::BitCast(hn::Rebind<hwy::float16_t, FourTag>(), halves));
    };
    const auto even = ofTwo(0);
    const auto odd = ofTwo(4);
    return {numbers(hn::InterleaveLower(quads, even, odd)), numbers(hn::InterleaveUpper(quads, even, odd))};
}

/// The quads of four lanes, and of each of their three slopes.
struct FourAir {
    FourVec value, slope[3];
};

/// Reads lanes kFirst, kFirst + 4, kFirst + 8 and kFirst + 12.
template <bool kSlopes, int kFirst>
HWY_INLINE FourAir readFour(const AirField& field, const LanePlaces<FourVec>& at)
{
    const auto ends = [&](std::size_t offset)
                          HWY_ATTR { return endsOf(field.quads.data() + offset, at.node + kFirst); };
    const FourEnds a = ends(0);
    const FourEnds b = ends(field.row);
    const FourEnds c = ends(field.plane);
    const FourEnds e = ends(field.plane + field.row);
    const FourVec x = hn::Broadcast<kFirst>(at.beyond.x);
    const FourVec y = hn::Broadcast<kFirst>(at.beyond.y);
    const FourVec z = hn::Broadcast<kFirst>(at.beyond.z);
    const FourVec low = mixedYZ(a.low, b.low, c.low, e.low, y, z);
    const FourVec high = mixedYZ(a.high, b.high, c.high, e.high, y, z);
    FourAir out;
    out.value = mixed(low, high, x);
    if constexpr (kSlopes) {
        out.slope[0] = high - low;
        out.slope[1] = mixed(mixed(b.low - a.low, e.low - c.low, z), mixed(b.high - a.high, e.high - c.high, z), x);
        out.slope[2] = mixed(mixed(c.low - a.low, e.low - b.low, y), mixed(c.high - a.high, e.high - b.high, y), x);
    }
    return out;
}

/// From four vectors of quads to one of each of their numbers.
/// @return the fourth
HWY_INLINE FourVec transposed(FourVec a, FourVec b, FourVec c, FourVec e, Vec3<FourVec>& out)
{
    const FourTag d;
    const hn::CappedTag<std::uint64_t, 8> pairs;
    const auto lower = [&](FourVec first, FourVec second)
                           HWY_ATTR { return hn::BitCast(pairs, hn::InterleaveLower(d, first, second)); };
    const auto upper = [&](FourVec first, FourVec second)
                           HWY_ATTR { return hn::BitCast(pairs, hn::InterleaveUpper(d, first, second)); };
    const auto lowAB = lower(a, b);
    const auto lowCE = lower(c, e);
    const auto highAB = upper(a, b);
    const auto highCE = upper(c, e);
    out = {hn::BitCast(d, hn::InterleaveLower(pairs, lowAB, lowCE)),
        hn::BitCast(d, hn::InterleaveUpper(pairs, lowAB, lowCE)),
        hn::BitCast(d, hn::InterleaveLower(pairs, highAB, highCE))};
    return hn::BitCast(d, hn::InterleaveUpper(pairs, highAB, highCE));
}

/// Reads the air of all lanes.
template <bool kSlopes>
HWY_INLINE AirThere<FourVec> readLanes(const AirField& field, const LanePlaces<FourVec>& at)
{
    const FourAir first = readFour<kSlopes, 0>(field, at);
    const FourAir second = readFour<kSlopes, 1>(field, at);
    const FourAir third = readFour<kSlopes, 2>(field, at);
    const FourAir fourth = readFour<kSlopes, 3>(field, at);
    AirThere<FourVec> out;
    out.heat = transposed(first.value, second.value, third.value, fourth.value, out.velocity);
    if constexpr (kSlopes) {
        for (int axis = 0; axis < 3; ++axis) {
            (void)transposed(
                first.slope[axis], second.slope[axis], third.slope[axis], fourth.slope[axis], out.slope[axis]);
        }
    }
    return out;
}
#else
/// The quads of all lanes.
template <class D>
struct LaneQuads {
    HWY_ALIGN float quad[4 * hn::MaxLanes(D())];

    HWY_INLINE void put(std::size_t at, QuadVec value) { hn::StoreU(value, QuadTag(), quad + at); }

    template <class V = hn::VFromD<D>>
    HWY_INLINE V take(Vec3<V>& out) const
    {
        V fourth;
        hn::LoadInterleaved4(D(), quad, out.x, out.y, out.z, fourth);
        return fourth;
    }
};

/// Reads the air of all lanes.
template <bool kSlopes, SimdVector V, class D = hn::DFromV<V>>
HWY_INLINE AirThere<V> readLanes(const AirField& field, const LanePlaces<V>& at)
{
    const D d;
    HWY_ALIGN float share[3][hn::MaxLanes(d)];
    store(at.beyond, share[0], share[1], share[2], 0);
    LaneQuads<D> value;
    LaneQuads<D> slope[3];
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
        const auto each = [&](int axis, auto like) HWY_ATTR { return everyLane<decltype(like)>(share[axis][lane]); };
        for (std::size_t part = 0; part < 4; part += hn::Lanes(QuadTag())) {
            const std::uint16_t* quad = field.quads.data() + at.node[lane] + part;
            const QuadVec x = everyLane<QuadVec>(share[0][lane]);
            const auto read = [&](auto a, auto b, auto c, auto e)
                                  HWY_ATTR { return mixedYZ(a, b, c, e, each(1, a), each(2, a)); };
            const Ends ends = combinedRows(quad, field.row, field.plane, read);
            value.put(4 * lane + part, mixed(ends.low, ends.high, x));
            if constexpr (kSlopes) {
                const Ends alongY = combinedRows(quad, field.row, field.plane,
                    [&](auto a, auto b, auto c, auto e) HWY_ATTR { return mixed(b - a, e - c, each(2, a)); });
                const Ends alongZ = combinedRows(quad, field.row, field.plane,
                    [&](auto a, auto b, auto c, auto e) HWY_ATTR { return mixed(c - a, e - b, each(1, a)); });
                slope[0].put(4 * lane + part, ends.high - ends.low);
                slope[1].put(4 * lane + part, mixed(alongY.low, alongY.high, x));
                slope[2].put(4 * lane + part, mixed(alongZ.low, alongZ.high, x));
            }
        }
    }
    AirThere<V> out;
    out.heat = value.take(out.velocity);
    if constexpr (kSlopes) {
        for (int axis = 0; axis < 3; ++axis) {
            (void)slope[axis].take(out.slope[axis]);
        }
    }
    return out;
}
#endif

/// Takes air back by a share, its velocity being that against the wind.
template <bool kSlopes, SimdVector V>
HWY_INLINE void fadeOut(V left, AirThere<V>& there)
{
    there.heat = there.heat * left;
    there.velocity = there.velocity * left;
    if constexpr (kSlopes) {
        for (Vec3<V>& slope : there.slope) {
            slope = slope * left;
        }
    }
}

/// Finds places, in metres, among the nodes; apart from airAt(), so that what does not need the air can be done before
/// it comes out of memory.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE LanePlaces<V> placesIn(D d, const AirField& field, const Vec3<V>& place)
{
    const hn::RebindToSigned<D> di;
    const glm::vec3 end(field.grid.cells);
    const Vec3<V> cells = (place - field.grid.corner) * (1.0F / field.grid.cell);
    const auto within = [&](V p, float last) HWY_ATTR { return hn::Min(hn::Max(p, hn::Zero(d)), hn::Set(d, last)); };
    const Vec3<V> inside{within(cells.x, end.x), within(cells.y, end.y), within(cells.z, end.z)};
    const auto lowOf = [&](V p, float last) HWY_ATTR { return hn::Min(hn::Floor(p), hn::Set(d, last - 1.0F)); };
    const Vec3<V> low{lowOf(inside.x, end.x), lowOf(inside.y, end.y), lowOf(inside.z, end.z)};
    LanePlaces<V> at;
    // Below 2^24, so that floats are exact.
    hn::Store(hn::ConvertTo(
                  di, low.x * 4.0F + low.y * static_cast<float>(field.row) + low.z * static_cast<float>(field.plane)),
        di, at.node);
    at.beyond = inside - low;
    const Vec3<V> outside = cells - inside;
    at.outside2 = dot(outside, outside);
    return at;
}

/// The air at places. Outside the box the velocity goes over into the wind within its reach, so that smoke which leaves
/// does not stop at the border.
/// @param reach m
template <bool kSlopes, SimdVector V>
HWY_INLINE AirThere<V> airAt(const AirField& field, float reach, const LanePlaces<V>& at)
{
    const hn::DFromV<V> d;
    AirThere<V> there = readLanes<kSlopes>(field, at);

    const Vec3<V> wind = broadcast(d, field.wind);
    there.velocity = there.velocity - wind;
    if (!hn::AllTrue(d, hn::Eq(at.outside2, hn::Zero(d)))) {
        const V closeness = hn::Max(hn::Zero(d), 1.0F - hn::Sqrt(at.outside2) * (field.grid.cell / reach));
        fadeOut<kSlopes>(closeness * closeness, there);
    }
    there.velocity = wind + there.velocity;
    return there;
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
