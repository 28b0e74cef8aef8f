#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/flow/advection_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/math-inl.h"
#include "core/flow/advection_kernel.h"
#include "core/flow/corners-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::CappedTag<float, kAirLanes>;
using V = hn::Vec<D>;
using DI = hn::RebindToSigned<D>;

constexpr std::size_t kRowRoom = kMaxAirCells + kAirLanes;

/// Places that a row of cells reads from.
struct PlaceRow {
    HWY_ALIGN std::int32_t
        corner[kRowRoom]; ///< floats from the first quad, ghosts included, to that of the lowest corner
    HWY_ALIGN float x[kRowRoom];
    HWY_ALIGN float y[kRowRoom];
    HWY_ALIGN float z[kRowRoom];
    std::uint8_t alike[2 * kRowRoom
        / 8]; ///< a bit a cell: whether its corner is as far from it as that of the first of its four cells

    [[nodiscard]] HWY_INLINE Between between(std::size_t i) const { return {x[i], y[i], z[i]}; }
    /// Whether the corners of a cell and the three behind it are beside one another. Air that moves evenly is so nearly
    /// everywhere.
    /// @param i a multiple of 4
    [[nodiscard]] HWY_INLINE bool fourAlike(std::size_t i) const { return (alike[i / 8] >> (i % 8) & 15U) == 15U; }
};

/// Quads of a row of cells.
struct QuadRow {
    HWY_ALIGN float quad[4 * kRowRoom];
};

/// Splits places, in cells from the centre of cell (0, 0, 0), into corner and rest; no place lies outside the box.
HWY_INLINE void split(D d, const AirCells& cells, const Vec3<V>& place, std::size_t i, PlaceRow& out)
{
    const auto along = [&](V p, int n) HWY_ATTR {
        return hn::Min(hn::Max(p, hn::Set(d, -0.5F)), hn::Set(d, static_cast<float>(n) - 0.5F));
    };
    const Vec3<V> inside{
        along(place.x, cells.grid.cells.x), along(place.y, cells.grid.cells.y), along(place.z, cells.grid.cells.z)};
    const Vec3<V> low{hn::Floor(inside.x), hn::Floor(inside.y), hn::Floor(inside.z)};
    // Below 2^24, so that floats are exact.
    const V corner = (low.x + 1.0F) * 4.0F + (low.y + 1.0F) * static_cast<float>(cells.quad.row)
        + (low.z + 1.0F) * static_cast<float>(cells.quad.plane);
    const auto whole = hn::ConvertTo(DI(), corner);
    hn::Store(whole, DI(), out.corner + i);
    store(inside - low, out.x, out.y, out.z, i);
#if HWY_MAX_BYTES >= 64
    const auto way = whole - hn::Iota(DI(), 0) * 4;
    hn::StoreMaskBits(DI(), hn::Eq(way, hn::Broadcast<0>(way)), out.alike + i / 8);
#endif
}

/// The places of a row's cells.
HWY_INLINE Vec3<V> centres(D d, std::size_t i, int j, int k)
{
    return {hn::Iota(d, static_cast<float>(i)), hn::Set(d, static_cast<float>(j)), hn::Set(d, static_cast<float>(k))};
}

HWY_INLINE Vec3<V> velocities(D d, const float* quads)
{
    Vec3<V> v;
    V heat;
    hn::LoadInterleaved4(d, quads, v.x, v.y, v.z, heat);
    return v;
}

/// Calls four(i) for four cells of a row whose corners are beside one another, where vectors have room for as many, and
/// part(i, p) for all others, p the first number of a part of their quads.
template <class Four, class Part>
HWY_INLINE void forQuads([[maybe_unused]] const PlaceRow& places, int cells, const Four& four, const Part& part)
{
    const auto parts = [&](std::size_t first, std::size_t last) HWY_ATTR {
        for (std::size_t i = first; i < last; ++i) {
            for (std::size_t p = 0; p < 4; p += hn::Lanes(QuadTag())) {
                part(i, p);
            }
        }
    };
    const auto n = static_cast<std::size_t>(cells);
    std::size_t i = 0;
#if HWY_MAX_BYTES >= 64
    for (; i + 4 <= n; i += 4) {
        if (places.fourAlike(i)) {
            four(i);
        } else {
            parts(i, i + 4);
        }
    }
#else
    (void)four;
#endif
    parts(i, n);
}

/// Reads the air at the places of a row.
HWY_INLINE void sampleRow(
    const AirCells& cells, const float* HWY_RESTRICT quads, const PlaceRow& places, float* HWY_RESTRICT out)
{
    const std::size_t row = cells.quad.row;
    const std::size_t plane = cells.quad.plane;
    const auto four = [&]([[maybe_unused]] std::size_t i) HWY_ATTR {
#if HWY_MAX_BYTES >= 64
        hn::StoreU(sampledFour(quads + places.corner[i], row, plane, places.x + i, places.y + i, places.z + i),
            FourTag(), out + 4 * i);
#endif
    };
    forQuads(places, cells.grid.cells.x, four, [&](std::size_t i, std::size_t part) HWY_ATTR {
        hn::StoreU(
            sampled(quads + places.corner[i] + part, row, plane, places.between(i)), QuadTag(), out + 4 * i + part);
    });
}

void tracePlane(AirCells& cells, float dt, int k)
{
    const D d;
    const auto n = static_cast<std::size_t>(cells.grid.cells.x);
    const float cellsPerSpeed = dt / cells.grid.cell;
    PlaceRow places;
    QuadRow middle{};
    for (int j = 0; j < cells.grid.cells.y; ++j) {
        const float* here = cells.carrier.data() + cells.quad.at(0, j, k);
        const std::size_t column = cells.column.at(0, j, k);
        for (std::size_t i = 0; i < n; i += hn::Lanes(d)) {
            split(d, cells, centres(d, i, j, k) - velocities(d, here + 4 * i) * (0.5F * cellsPerSpeed), i, places);
        }
        sampleRow(cells, cells.carrier.data(), places, middle.quad);
        for (std::size_t i = 0; i < n; i += hn::Lanes(d)) {
            const Vec3<V> way = velocities(d, middle.quad + 4 * i) * cellsPerSpeed;
            store(way, cells.forced.x, cells.forced.y, cells.forced.z, column + i);
            split(d, cells, centres(d, i, j, k) - way, i, places);
        }
        sampleRow(cells, cells.air.data(), places, cells.guess.data() + cells.quad.at(0, j, k));
    }
}

/// q' from the guess, for the cells of a row.
/// @param back of the row's cells; becomes q'
HWY_INLINE void correctRow(const AirCells& cells, std::size_t here, const PlaceRow& from, float* HWY_RESTRICT back)
{
    const std::size_t row = cells.quad.row;
    const std::size_t plane = cells.quad.plane;
    const float* HWY_RESTRICT air = cells.air.data();
    const float* HWY_RESTRICT guess = cells.guess.data();
    const auto corrected = [&](auto d, std::size_t at) HWY_ATTR {
        return hn::LoadU(d, guess + here + at) + 0.5F * (hn::LoadU(d, air + here + at) - hn::LoadU(d, back + at));
    };
    const auto four = [&]([[maybe_unused]] std::size_t i) HWY_ATTR {
#if HWY_MAX_BYTES >= 64
        hn::StoreU(limitedFour(air + from.corner[i], row, plane, corrected(FourTag(), 4 * i)), FourTag(), back + 4 * i);
#endif
    };
    forQuads(from, cells.grid.cells.x, four, [&](std::size_t i, std::size_t part) HWY_ATTR {
        const QuadTag d;
        hn::StoreU(
            limited(air + from.corner[i] + part, row, plane, corrected(d, 4 * i + part)), d, back + 4 * i + part);
    });
}

void correctPlane(AirCells& cells, float dt, int k)
{
    const D d;
    const auto n = static_cast<std::size_t>(cells.grid.cells.x);
    PlaceRow from;
    PlaceRow to;
    QuadRow corrected{};
    for (int j = 0; j < cells.grid.cells.y; ++j) {
        const std::size_t column = cells.column.at(0, j, k);
        const float* here = cells.carrier.data() + cells.quad.at(0, j, k);
        for (std::size_t i = 0; i < n; i += hn::Lanes(d)) {
            const Vec3<V> way = load(d, cells.forced.x, cells.forced.y, cells.forced.z, column + i);
            // What leaves here turns the other way than what arrives: (d+ + d-) / 2 = dt u.
            const Vec3<V> wayOn = velocities(d, here + 4 * i) * (2.0F * dt / cells.grid.cell) - way;
            split(d, cells, centres(d, i, j, k) - way, i, from);
            split(d, cells, centres(d, i, j, k) + wayOn, i, to);
        }
        sampleRow(cells, cells.guess.data(), to, corrected.quad);
        correctRow(cells, cells.quad.at(0, j, k), from, corrected.quad);
        for (std::size_t i = 0; i < n; i += hn::Lanes(d)) {
            Vec3<V> v;
            V heat;
            hn::LoadInterleaved4(d, corrected.quad + 4 * i, v.x, v.y, v.z, heat);
            store(v, cells.velocity.x, cells.velocity.y, cells.velocity.z, column + i);
            hn::Store(heat, d, cells.heat.data() + column + i);
        }
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(tracePlane);
HWY_EXPORT(correctPlane);

void traceBack(AirCells& cells, float dt, int k)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(tracePlane);
    kernel(cells, dt, k);
}

void correctTrace(AirCells& cells, float dt, int k)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(correctPlane);
    kernel(cells, dt, k);
}

} // namespace fumage
#endif
