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

/// Where the lanes' places are among the nodes.
struct LanePlaces {
    HWY_ALIGN std::int32_t node[LaneQuads::kLanes]; ///< halfs from the first node to the lowest corner
    HWY_ALIGN float x[LaneQuads::kLanes]; ///< how far beyond it, in cells
    HWY_ALIGN float y[LaneQuads::kLanes];
    HWY_ALIGN float z[LaneQuads::kLanes];
};

/// What is read for all lanes.
struct LaneAir {
    LaneQuads value;
    LaneQuads slope[3]; ///< along x, y and z, a cell
};

/// Reads the air of one lane.
template <bool kSlopes>
HWY_INLINE void readLane(const AirField& field, const LanePlaces& at, std::size_t lane, LaneAir& out)
{
    for (std::size_t part = 0; part < 4; part += hn::Lanes(QuadTag())) {
        const std::uint16_t* quad = field.quads.data() + at.node[lane] + part;
        const QuadVec x = everyLane<QuadVec>(at.x[lane]);
        const auto every = [](float number, auto like) HWY_ATTR { return everyLane<decltype(like)>(number); };
        const auto read = [&](auto a, auto b, auto c, auto e) HWY_ATTR { return mixedYZ(a, b, c, e, every(at.y[lane], a), every(at.z[lane], a)); };
        const Ends ends = combinedRows(quad, field.row, field.plane, read);
        out.value.put(4 * lane + part, mixed(ends.low, ends.high, x));
        if constexpr (kSlopes) {
            const auto changeY = [&](auto a, auto b, auto c, auto e) HWY_ATTR { return mixed(b - a, e - c, every(at.z[lane], a)); };
            const auto changeZ = [&](auto a, auto b, auto c, auto e) HWY_ATTR { return mixed(c - a, e - b, every(at.y[lane], a)); };
            const Ends alongY = combinedRows(quad, field.row, field.plane, changeY);
            const Ends alongZ = combinedRows(quad, field.row, field.plane, changeZ);
            out.slope[0].put(4 * lane + part, ends.high - ends.low);
            out.slope[1].put(4 * lane + part, mixed(alongY.low, alongY.high, x));
            out.slope[2].put(4 * lane + part, mixed(alongZ.low, alongZ.high, x));
        }
    }
}

#if HWY_MAX_BYTES >= 64
// The same for four lanes: two at a time until y and z are done, both ends of a row side by side, then all four with an end in each of two vectors.

/// Both ends of two lanes.
struct TwoLanes {
    FourVec value, alongY, alongZ;
};

template <bool kSlopes>
HWY_INLINE TwoLanes readTwo(const AirField& field, const LanePlaces& at, std::size_t first, std::size_t second)
{
    const FourTag d;
    const hn::Half<FourTag> half;
    const auto rowAt = [&](std::size_t offset) HWY_ATTR {
        const hn::CappedTag<std::uint16_t, 16> both;
        const auto ends = [&](std::size_t lane) HWY_ATTR { return hn::LoadU(hn::Half<decltype(both)>(), field.quads.data() + at.node[lane] + offset); };
        return hn::PromoteTo(d, hn::BitCast(hn::Rebind<hwy::float16_t, FourTag>(), hn::Combine(both, ends(second), ends(first))));
    };
    const auto shares = [&](const float* of) HWY_ATTR { return hn::Combine(d, hn::Set(half, of[second]), hn::Set(half, of[first])); };
    const FourVec a = rowAt(0);
    const FourVec b = rowAt(field.row);
    const FourVec c = rowAt(field.plane);
    const FourVec e = rowAt(field.plane + field.row);
    const FourVec y = shares(at.y);
    const FourVec z = shares(at.z);
    TwoLanes out{mixedYZ(a, b, c, e, y, z), a, a};
    if constexpr (kSlopes) {
        out.alongY = mixed(b - a, e - c, z);
        out.alongZ = mixed(c - a, e - b, y);
    }
    return out;
}

/// The low and the high ends of four lanes.
struct FourEnds {
    FourEnds(FourVec firstAndThird, FourVec secondAndFourth)
        : low(hn::OddEvenBlocks(hn::SwapAdjacentBlocks(secondAndFourth), firstAndThird))
        , high(hn::OddEvenBlocks(secondAndFourth, hn::SwapAdjacentBlocks(firstAndThird)))
    {
    }

    FourVec low, high;
};

template <bool kSlopes>
HWY_INLINE void readFour(const AirField& field, const LanePlaces& at, std::size_t lane, LaneAir& out)
{
    const TwoLanes even = readTwo<kSlopes>(field, at, lane, lane + 2);
    const TwoLanes odd = readTwo<kSlopes>(field, at, lane + 1, lane + 3);
    const FourVec x = eachForQuad(at.x + lane);
    const auto put = [&](FourVec value, LaneQuads& to) HWY_ATTR { hn::Store(value, FourTag(), to.quad + 4 * lane); };
    const FourEnds ends(even.value, odd.value);
    put(mixed(ends.low, ends.high, x), out.value);
    if constexpr (kSlopes) {
        const FourEnds alongY(even.alongY, odd.alongY);
        const FourEnds alongZ(even.alongZ, odd.alongZ);
        put(ends.high - ends.low, out.slope[0]);
        put(mixed(alongY.low, alongY.high, x), out.slope[1]);
        put(mixed(alongZ.low, alongZ.high, x), out.slope[2]);
    }
}
#endif

/// Reads the air of all lanes.
template <bool kSlopes>
HWY_INLINE void readLanes(const AirField& field, const LanePlaces& at, std::size_t lanes, LaneAir& out)
{
#if HWY_MAX_BYTES >= 64
    for (std::size_t lane = 0; lane < lanes; lane += 4) {
        readFour<kSlopes>(field, at, lane, out);
    }
#else
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        readLane<kSlopes>(field, at, lane, out);
    }
#endif
}

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
    LanePlaces at;
    // Below 2^24, so that floats are exact.
    hn::Store(hn::ConvertTo(di, low.x * 4.0F + low.y * static_cast<float>(field.row) + low.z * static_cast<float>(field.plane)), di, at.node);
    store(inside - low, at.x, at.y, at.z, 0);
    LaneAir air;
    readLanes<kSlopes>(field, at, hn::Lanes(d), air);

    const Vec3<V> outside = cells - inside;
    const V beyond = hn::Sqrt(dot(outside, outside)) * (field.grid.cell / reach);
    const V near = hn::Max(hn::Zero(d), 1.0F - beyond);
    const V fade = near * near;
    AirThere<V> there;
    there.heat = air.value.take(d, there.velocity) * fade;
    const Vec3<V> wind = broadcast(d, field.wind);
    there.velocity = wind + (there.velocity - wind) * fade;
    if constexpr (kSlopes) {
        for (int axis = 0; axis < 3; ++axis) {
            (void)air.slope[axis].take(d, there.slope[axis]);
            there.slope[axis] = there.slope[axis] * fade;
        }
    }
    return there;
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
