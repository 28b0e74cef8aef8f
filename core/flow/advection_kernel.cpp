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
    HWY_ALIGN std::int32_t corner[kRowRoom]; ///< floats from the first quad, ghosts included, to that of the lowest corner
    HWY_ALIGN float x[kRowRoom];
    HWY_ALIGN float y[kRowRoom];
    HWY_ALIGN float z[kRowRoom];

    [[nodiscard]] HWY_INLINE Between between(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// Quads of a row of cells.
struct QuadRow {
    HWY_ALIGN float quad[4 * kRowRoom];
};

/// Splits places, in cells from the centre of cell (0, 0, 0), into corner and rest; no place lies outside the box.
HWY_INLINE void split(D d, const AirCells& cells, const Vec3<V>& place, std::size_t i, PlaceRow& out)
{
    const DI di;
    const auto along = [&](V p, int n) HWY_ATTR { return hn::Min(hn::Max(p, hn::Set(d, -0.5F)), hn::Set(d, static_cast<float>(n) - 0.5F)); };
    const Vec3<V> inside{along(place.x, cells.grid.cells.x), along(place.y, cells.grid.cells.y), along(place.z, cells.grid.cells.z)};
    const Vec3<V> low{hn::Floor(inside.x), hn::Floor(inside.y), hn::Floor(inside.z)};
    const auto whole = [&](V number) HWY_ATTR { return hn::ConvertTo(di, number) + 1; };
    const auto row = static_cast<std::int32_t>(cells.quad.row);
    const auto plane = static_cast<std::int32_t>(cells.quad.plane);
    hn::Store(whole(low.x) * 4 + whole(low.y) * row + whole(low.z) * plane, di, out.corner + i);
    store(inside - low, out.x, out.y, out.z, i);
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

/// Reads the air at the places of a row.
HWY_INLINE void sampleRow(const AirCells& cells, const float* HWY_RESTRICT quads, const PlaceRow& places, float* HWY_RESTRICT out)
{
    const QuadTag dq;
    const std::size_t row = cells.quad.row;
    const std::size_t plane = cells.quad.plane;
    for (std::size_t i = 0; i < static_cast<std::size_t>(cells.grid.cells.x); ++i) {
        const float* corner = quads + places.corner[i];
        for (std::size_t part = 0; part < 4; part += hn::Lanes(dq)) {
            hn::StoreU(sampled(corner + part, row, plane, places.between(i)), dq, out + 4 * i + part);
        }
    }
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
            store(way, cells.way.x, cells.way.y, cells.way.z, column + i);
            split(d, cells, centres(d, i, j, k) - way, i, places);
        }
        sampleRow(cells, cells.air.data(), places, cells.guess.data() + cells.quad.at(0, j, k));
    }
}

/// q' from the guess, for the cells of a row.
HWY_INLINE void correctRow(const AirCells& cells, std::size_t here, const PlaceRow& from, const PlaceRow& to, float* HWY_RESTRICT out)
{
    const QuadTag dq;
    const std::size_t row = cells.quad.row;
    const std::size_t plane = cells.quad.plane;
    const float* HWY_RESTRICT air = cells.air.data();
    const float* HWY_RESTRICT guess = cells.guess.data();
    for (std::size_t i = 0; i < static_cast<std::size_t>(cells.grid.cells.x); ++i) {
        for (std::size_t part = 0; part < 4; part += hn::Lanes(dq)) {
            const std::size_t at = here + 4 * i + part;
            const QuadVec back = sampled(guess + to.corner[i] + part, row, plane, to.between(i));
            const QuadVec corrected = hn::LoadU(dq, guess + at) + 0.5F * (hn::LoadU(dq, air + at) - back);
            hn::StoreU(limited(air + from.corner[i] + part, row, plane, corrected), dq, out + 4 * i + part);
        }
    }
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
            const Vec3<V> way = load(d, cells.way.x, cells.way.y, cells.way.z, column + i);
            // What leaves here turns the other way than what arrives: (d+ + d-) / 2 = dt u.
            const Vec3<V> wayOn = velocities(d, here + 4 * i) * (2.0F * dt / cells.grid.cell) - way;
            split(d, cells, centres(d, i, j, k) - way, i, from);
            split(d, cells, centres(d, i, j, k) + wayOn, i, to);
        }
        correctRow(cells, cells.quad.at(0, j, k), from, to, corrected.quad);
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
