#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/flow/force_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/math-inl.h"
#include "core/flow/force_kernel.h"
#include "core/flow/row_sums-inl.h"
#include "core/flow/speed-inl.h"
#include "core/noise/simplex-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::CappedTag<float, kAirLanes>;
using V = hn::Vec<D>;

/// Half the difference of the neighbours.
HWY_INLINE V slope(D d, const float* HWY_RESTRICT at, std::size_t stride)
{
    return 0.5F * (hn::LoadU(d, at + stride) - hn::LoadU(d, at - stride));
}

/// Ghosts around a plane, as the cells beside them; corners stay as they are.
HWY_INLINE void fillRing(const ColumnLayout& layout, float* numbers)
{
    const auto n = static_cast<std::size_t>(layout.cells.x);
    for (int j = 0; j < layout.cells.y; ++j) {
        float* row = numbers + CurlPlane::at(layout, j);
        *(row - 1) = *row;
        row[n] = row[n - 1];
    }
    std::copy_n(numbers + CurlPlane::at(layout, 0), n, numbers + CurlPlane::at(layout, -1));
    std::copy_n(
        numbers + CurlPlane::at(layout, layout.cells.y - 1), n, numbers + CurlPlane::at(layout, layout.cells.y));
}

void curlPlane(const AirCells& cells, int k, CurlPlane& out)
{
    const D d;
    const std::size_t row = cells.column.row;
    const std::size_t plane = cells.column.plane;
    const auto n = static_cast<std::size_t>(cells.grid.cells.x);
    for (int j = 0; j < cells.grid.cells.y; ++j) {
        const std::size_t start = cells.column.at(0, j, k);
        const std::size_t to = CurlPlane::at(cells.column, j);
        for (std::size_t i = 0; i < n; i += hn::Lanes(d)) {
            const float* u = cells.velocity.x.data() + start + i;
            const float* v = cells.velocity.y.data() + start + i;
            const float* w = cells.velocity.z.data() + start + i;
            const Vec3<V> curl{slope(d, w, row) - slope(d, v, plane), slope(d, u, plane) - slope(d, w, 1),
                slope(d, v, 1) - slope(d, u, row)};
            store(curl, out.curl.x, out.curl.y, out.curl.z, to + i);
            hn::Store(hn::Sqrt(dot(curl, curl)), d, out.vorticity.data() + to + i);
        }
    }
    fillRing(cells.column, out.vorticity.data());
}

/// epsilon (N x w) dt, m/s. N is of length 1, or shorter where the vorticity is so even that it has no direction.
/// @param at in the planes of the curl
HWY_INLINE Vec3<V> confinement(D d, const CurlAround& around, std::size_t row, float strength, std::size_t at)
{
    const float* size = around[1]->vorticity.data() + at;
    const V alongZ =
        0.5F * (hn::Load(d, around[2]->vorticity.data() + at) - hn::Load(d, around[0]->vorticity.data() + at));
    const Vec3<V> gradient{slope(d, size, 1), slope(d, size, row), alongZ};
    constexpr float kEven = 1e-6F; // m/s a cell
    const V scale = strength / (hn::Sqrt(dot(gradient, gradient)) + kEven);
    const AirVectors& curl = around[1]->curl;
    return cross(gradient, load(d, curl.x, curl.y, curl.z, at)) * scale;
}

/// What a wall in the cell leaves of the air's velocity in it: 1 / (1 + c dt |u| / h), which is stable for any drag c.
HWY_INLINE V afterDrag(D d, const AirCells& cells, const AirStep& step, bool onGround, const Vec3<V>& v, std::size_t at)
{
    V walls = hn::Set(d, onGround ? 1.0F : 0.0F);
    if (cells.hasObstacles()) {
        walls = walls + hn::Load(d, cells.touching.data() + at);
    }
    return 1.0F / (1.0F + walls * (step.friction * step.dt / cells.grid.cell) * hn::Sqrt(dot(v, v)));
}

/// Velocity that obstacles which move have where a cell touches them, as a share of all walls that it touches, m/s.
HWY_INLINE Vec3<V> velocityOfWalls(D d, const AirCells& cells, bool onGround, std::size_t at)
{
    const V touching = hn::Load(d, cells.touching.data() + at);
    const V walls = touching + hn::Set(d, onGround ? 1.0F : 0.0F);
    return broadcast(d, cells.wallVelocity) * (touching / hn::Max(walls, hn::Set(d, 1.0F)));
}

/// The air's velocity after the drag of walls that move, which is against what they have themselves.
HWY_INLINE Vec3<V> slowedByWalls(
    D d, const AirCells& cells, const AirStep& step, bool onGround, const Vec3<V>& v, std::size_t at)
{
    const Vec3<V> walls = velocityOfWalls(d, cells, onGround, at);
    const Vec3<V> against = v - walls;
    return against * afterDrag(d, cells, step, onGround, against, at) + walls;
}

/// Velocity of an obstacle that moves in a cell of it, m/s; 0 in air.
HWY_INLINE Vec3<V> velocityInWall(D d, const AirCells& cells, std::size_t at)
{
    const V inside = 0.5F * (1.0F - hn::Load(d, cells.fluid.data() + at));
    const auto along = [&](const AirColumn& faces, std::size_t stride) HWY_ATTR {
        return inside * (hn::Load(d, faces.data() + at) + hn::LoadU(d, faces.data() + at + stride));
    };
    return {along(cells.wall.x, 1), along(cells.wall.y, cells.column.row), along(cells.wall.z, cells.column.plane)};
}

/// What a swirl adds to the air's velocity: a share of what this lacks along the tangent, and what holds air of that
/// speed on its circle.
HWY_INLINE Vec3<V> swirled(D d, const AirVortex& swirl, float dt, const Vec3<V>& away, const Vec3<V>& v)
{
    const Vec3<V> axis = broadcast(d, swirl.axis);
    const Vec3<V> tangent = cross(axis, away); // as long as the distance from the axis
    const V distance2 = dot(tangent, tangent);
    constexpr float kOnAxis = 1e-12F; // m^2
    const V radius = swirl.widening * hn::Max(dot(away, axis), hn::Zero(d)) + swirl.radius;
    const V wanted = (2.0F * swirl.speed) * radius / (distance2 + radius * radius);
    return (swirl.relaxation * (wanted - dot(v, tangent) / (distance2 + kOnAxis))) * tangent
        + (dt * wanted * wanted) * cross(axis, tangent);
}

/// The acceleration of what stirs the air, m/s^2.
HWY_INLINE Vec3<V> stirred(D d, const TurbulenceForcing& forcing, const Vec3<V>& place, V heat)
{
    Vec3<V> sum = uniform(hn::Zero(d));
    const Vec3<V> away = place - forcing.place;
    const V ramp = clamp01(d, hn::Sqrt(dot(away, away)) * (1.0F / forcing.calm) - 1.0F);
    const V share = ramp * hn::Min(heat, hn::Set(d, 1.0F));
    // Most of a box is cold.
    if (hn::AllFalse(d, hn::Gt(share, hn::Zero(d)))) {
        return sum;
    }
    Vec3<V> none = sum;
    for (std::size_t i = 0; i < forcing.octaves; ++i) {
        const AirOctave& octave = forcing.octave[i];
        addCurlNoise<false, 2>(d, place * octave.frequency + octave.shift, octave.slices, sum, none);
    }
    return sum * (share * forcing.strength);
}

/// Cells of a row that are air.
HWY_INLINE auto airOf(D d, const AirCells& cells, std::size_t at, std::size_t left)
{
    const auto isInRow = hn::FirstN(d, left);
    return cells.hasObstacles() ? hn::And(isInRow, hn::Ne(hn::Load(d, cells.fluid.data() + at), hn::Zero(d))) : isInRow;
}

/// Sums over a plane of what confinement does.
struct VorticitySums {
    RowSums motion, along, own;

    /// @param isAir  which of the cells count
    /// @param v      velocity against the wind, without the confinement
    /// @param swirl  what the confinement adds to it
    template <class M>
    HWY_INLINE void put(D d, std::size_t i, M isAir, const Vec3<V>& v, const Vec3<V>& swirl)
    {
        motion.put(d, i, hn::IfThenElseZero(isAir, dot(v, v)));
        along.put(d, i, hn::IfThenElseZero(isAir, dot(v, swirl)));
        own.put(d, i, hn::IfThenElseZero(isAir, dot(swirl, swirl)));
    }

    HWY_INLINE void add(std::size_t n)
    {
        motion.add(n);
        along.add(n);
        own.add(n);
    }
};

void forcePlane(AirCells& cells, const AirStep& step, int k, const CurlAround& curl, ConfinementWork& work)
{
    const D d;
    const auto n = static_cast<std::size_t>(cells.grid.cells.x);
    const bool confines = step.confinement > 0.0F;
    const bool wallsMove = cells.hasMovingWallsBeside(k);
    VorticitySums sums;
    for (int j = 0; j < cells.grid.cells.y; ++j) {
        const bool onGround = j == 0 && cells.boundaries.low[1] == Boundary::Solid;
        const std::size_t start = cells.column.at(0, j, k);
        const std::size_t inPlane = CurlPlane::at(cells.column, j);
        const glm::vec3 rowStart = cells.grid.centre({0, j, k});
        for (std::size_t i = 0; i < n; i += hn::Lanes(d)) {
            const std::size_t at = start + i;
            const V heat = hn::Load(d, cells.heat.data() + at);
            Vec3<V> v = load(d, cells.velocity.x, cells.velocity.y, cells.velocity.z, at) + step.windChange;
            v.y = v.y + heat * (step.dt * step.buoyancy);
            if (confines) {
                const Vec3<V> swirl = confinement(d, curl, cells.column.row, step.confinement * step.dt, inPlane + i);
                sums.put(d, i, airOf(d, cells, at, n - i), v - step.wind, swirl);
                v = v + swirl;
            }
            const Vec3<V> place{hn::Iota(d, static_cast<float>(i)) * cells.grid.cell + rowStart.x,
                hn::Set(d, rowStart.y), hn::Set(d, rowStart.z)};
            if (step.vortex.speed != 0.0F) {
                v = v + swirled(d, step.vortex, step.dt, place - step.vortex.place, v);
            }
            for (const AirFeed& feed : step.others) {
                if (feed.vortex.speed != 0.0F) {
                    v = v + swirled(d, feed.vortex, step.dt, place - feed.vortex.place, v);
                }
            }
            if (step.forcing.strength > 0.0F) {
                v = v + stirred(d, step.forcing, place, heat) * step.dt;
            }
            if (step.friction > 0.0F && (onGround || cells.hasObstacles())) {
                v = wallsMove ? slowedByWalls(d, cells, step, onGround, v, at)
                              : v * afterDrag(d, cells, step, onGround, v, at);
            }
            if (cells.hasObstacles()) {
                v = v * hn::Load(d, cells.fluid.data() + at);
            }
            V kept = heat * step.heatKept;
            if (wallsMove) {
                v = v + velocityInWall(d, cells, at);
                kept = kept * hn::Load(d, cells.fluid.data() + at); // or it would come out again behind
            }
            store(boundedSpeed(d, v), cells.forced.x, cells.forced.y, cells.forced.z, at);
            hn::Store(kept, d, cells.heat.data() + at);
        }
        if (confines) {
            sums.add(n);
        }
    }
    if (confines) {
        work = {sums.motion.all(), sums.along.all(), sums.own.all()};
    }
}

void weakenPlane(AirCells& cells, const AirStep& step, float share, int k, const CurlAround& curl)
{
    const D d;
    const auto n = static_cast<std::size_t>(cells.grid.cells.x);
    for (int j = 0; j < cells.grid.cells.y; ++j) {
        const std::size_t start = cells.column.at(0, j, k);
        const std::size_t inPlane = CurlPlane::at(cells.column, j);
        for (std::size_t i = 0; i < n; i += hn::Lanes(d)) {
            const std::size_t at = start + i;
            Vec3<V> swirl = confinement(d, curl, cells.column.row, share * step.confinement * step.dt, inPlane + i);
            if (cells.hasObstacles()) {
                swirl = swirl * hn::Load(d, cells.fluid.data() + at);
            }
            const Vec3<V> forced = load(d, cells.forced.x, cells.forced.y, cells.forced.z, at);
            store(boundedSpeed(d, forced - swirl), cells.forced.x, cells.forced.y, cells.forced.z, at);
        }
    }
}

/// @param at reads the velocity of cells: at(column, quad)
template <class Velocity>
HWY_INLINE double motionOfPlane(const AirCells& cells, const glm::vec3& wind, int k, const Velocity& at)
{
    const D d;
    const auto n = static_cast<std::size_t>(cells.grid.cells.x);
    RowSums sum;
    for (int j = 0; j < cells.grid.cells.y; ++j) {
        const std::size_t column = cells.column.at(0, j, k);
        const std::size_t quad = cells.quad.at(0, j, k);
        for (std::size_t i = 0; i < n; i += hn::Lanes(d)) {
            const Vec3<V> v = at(column + i, quad + 4 * i) - wind;
            sum.put(d, i, hn::IfThenElseZero(airOf(d, cells, column + i, n - i), dot(v, v)));
        }
        sum.add(n);
    }
    return sum.all();
}

double motionBefore(const AirCells& cells, const glm::vec3& wind, int k)
{
    return motionOfPlane(cells, wind, k, [&](std::size_t /*column*/, std::size_t quad) HWY_ATTR {
        const D d;
        Vec3<V> v;
        V heat;
        hn::LoadInterleaved4(d, cells.air.data() + quad, v.x, v.y, v.z, heat);
        return v;
    });
}

double motionCarried(const AirCells& cells, const glm::vec3& wind, int k)
{
    return motionOfPlane(cells, wind, k, [&](std::size_t column, std::size_t /*quad*/) HWY_ATTR {
        return load(D(), cells.velocity.x, cells.velocity.y, cells.velocity.z, column);
    });
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(curlPlane);
HWY_EXPORT(forcePlane);
HWY_EXPORT(weakenPlane);
HWY_EXPORT(motionBefore);
HWY_EXPORT(motionCarried);

void weakenConfinement(AirCells& cells, const AirStep& step, float share, int k, const CurlAround& curl)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(weakenPlane);
    kernel(cells, step, share, k, curl);
}

double motionOfAir(const AirCells& cells, const glm::vec3& wind, int k)
{
    return HWY_DYNAMIC_DISPATCH(motionBefore)(cells, wind, k);
}

double motionOfCarried(const AirCells& cells, const glm::vec3& wind, int k)
{
    return HWY_DYNAMIC_DISPATCH(motionCarried)(cells, wind, k);
}

void findCurl(const AirCells& cells, int k, CurlPlane& out)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(curlPlane);
    kernel(cells, k, out);
}

void addForces(AirCells& cells, const AirStep& step, int k, const CurlAround& curl, ConfinementWork& work)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(forcePlane);
    kernel(cells, step, k, curl, work);
}

} // namespace fumage
#endif
