#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/flow/force_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/math-inl.h"
#include "core/flow/force_kernel.h"
#include "core/noise/simplex-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::CappedTag<float, kAirLanes>;
using V = hn::Vec<D>;

/// Fastest that the air may be in each component, m/s: a forced flow without end would else end in infinity. Half floats hold it.
constexpr float kMaxAirSpeed = 2000.0F;

/// 1 inside, 0 outside, smooth over a width around the border.
/// @param inside distance from the border, m
HWY_INLINE V covered(D d, V inside, float width)
{
    return smoothStep(clamp01(d, inside * (1.0F / width) + 0.5F));
}

/// Noise at a place: of the rim in x, of the speed in y, and of the heat in z, which has an octave more.
HWY_INLINE Vec3<V> sourceNoise(D d, const AirSource& source, const Vec3<V>& away)
{
    Vec3<V> sum = uniform(hn::Zero(d));
    Vec3<V> none = sum;
    const auto add = [&](const AirOctave& octave, Vec3<V>& to) HWY_ATTR { addCurlNoise<false, 2>(d, away * octave.frequency + octave.shift, octave.slices, to, none); };
    for (const AirOctave& octave : source.rim) {
        add(octave, sum);
    }
    if (source.unevenness > 0.0F) {
        Vec3<V> small = uniform(hn::Zero(d));
        add(source.billow, small);
        sum.z = sum.z + small.z;
    }
    return sum;
}

/// How much of places lies between the two ends of the source, 0 to 1. A sphere has none.
HWY_INLINE V betweenEnds(D d, const AirSource& source, const Vec3<V>& away)
{
    if (source.shape == EmitterShape::Sphere) {
        return hn::Set(d, 1.0F);
    }
    const V up = dot(away, source.normal);
    return covered(d, hn::Min(up + 0.5F * source.softness, source.depth - up), source.softness);
}

/// How much of places the source covers, 0 to 1: within its rim, which wanders, and its two ends.
HWY_INLINE V coverage(D d, const AirSource& source, const Vec3<V>& away, V ends, V wander)
{
    const V across = dot(away, source.basis.across);
    const V along = dot(away, source.basis.along);
    const V edge = 1.0F + source.raggedness * wander;
    if (source.shape == EmitterShape::Sphere) {
        return covered(d, edge * source.reach.x - hn::Sqrt(dot(away, away)), source.softness);
    }
    if (source.shape == EmitterShape::Rectangle) {
        return ends * covered(d, hn::Min(edge * source.reach.x - hn::Abs(across), edge * source.reach.y - hn::Abs(along)), source.softness);
    }
    return ends * covered(d, edge * source.reach.x - hn::Sqrt(across * across + along * along), source.softness);
}

void sourcePlane(AirCells& cells, const AirSource& source, int k)
{
    const D d;
    for (int j = source.first.y; j < source.last.y; ++j) {
        const glm::vec3 rowStart = cells.grid.corner + cells.grid.cell * (glm::vec3(0.0F, static_cast<float>(j), static_cast<float>(k)) + 0.5F) - source.place;
        const std::size_t row = cells.column.at(0, j, k);
        for (auto i = static_cast<std::size_t>(source.first.x); i < static_cast<std::size_t>(source.last.x); i += hn::Lanes(d)) {
            const std::size_t at = row + i;
            const Vec3<V> away{hn::Iota(d, static_cast<float>(i)) * cells.grid.cell + rowStart.x, hn::Set(d, rowStart.y), hn::Set(d, rowStart.z)};
            const V ends = betweenEnds(d, source, away);
            if (hn::AllFalse(d, hn::Gt(ends, hn::Zero(d)))) {
                continue;
            }
            const Vec3<V> noise = sourceNoise(d, source, away);
            const V cover = coverage(d, source, away, ends, noise.x);
            const V heat = hn::Load(d, cells.heat.data() + at);
            const V given = hn::Max(1.0F + source.unevenness * noise.z, hn::Zero(d)) * source.heat;
            hn::Store(hn::Max(heat, cover * given), d, cells.heat.data() + at);
            const Vec3<V> v = load(d, cells.velocity.x, cells.velocity.y, cells.velocity.z, at);
            // What comes out is as uneven as its rim, and blown along by the air that it comes into.
            const V lacking = source.speed * (1.0F + source.raggedness * noise.y) - dot(v, source.normal);
            store(v + (lacking * cover * source.grip) * source.normal, cells.velocity.x, cells.velocity.y, cells.velocity.z, at);
            hn::Store(cover * (source.expansion * cells.grid.cell), d, cells.divergence.data() + at);
        }
    }
}

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
    std::copy_n(numbers + CurlPlane::at(layout, layout.cells.y - 1), n, numbers + CurlPlane::at(layout, layout.cells.y));
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
            const Vec3<V> curl{slope(d, w, row) - slope(d, v, plane), slope(d, u, plane) - slope(d, w, 1), slope(d, v, 1) - slope(d, u, row)};
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
    const V alongZ = 0.5F * (hn::Load(d, around[2]->vorticity.data() + at) - hn::Load(d, around[0]->vorticity.data() + at));
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

/// What a swirl adds to the air's velocity: a share of what this lacks along the tangent, and what holds air of that speed on its circle.
HWY_INLINE Vec3<V> swirled(D d, const AirSwirl& swirl, float dt, const Vec3<V>& away, const Vec3<V>& v)
{
    const Vec3<V> axis = broadcast(d, swirl.axis);
    const Vec3<V> tangent = cross(axis, away); // as long as the distance from the axis
    const V distance2 = dot(tangent, tangent);
    constexpr float kOnAxis = 1e-12F; // m^2
    const V radius = swirl.widening * hn::Max(dot(away, axis), hn::Zero(d)) + swirl.radius;
    const V wanted = (2.0F * swirl.speed) * radius / (distance2 + radius * radius);
    return (swirl.grip * (wanted - dot(v, tangent) / (distance2 + kOnAxis))) * tangent + (dt * wanted * wanted) * cross(axis, tangent);
}

/// The acceleration of what stirs the air, m/s^2.
HWY_INLINE Vec3<V> stirred(D d, const AirStirring& stirring, const Vec3<V>& place, V heat)
{
    Vec3<V> sum = uniform(hn::Zero(d));
    const Vec3<V> away = place - stirring.place;
    const V ramp = clamp01(d, hn::Sqrt(dot(away, away)) * (1.0F / stirring.calm) - 1.0F);
    const V share = ramp * hn::Min(heat, hn::Set(d, 1.0F));
    // Most of a box is cold.
    if (hn::AllFalse(d, hn::Gt(share, hn::Zero(d)))) {
        return sum;
    }
    Vec3<V> none = sum;
    for (std::size_t i = 0; i < stirring.octaves; ++i) {
        const AirOctave& octave = stirring.octave[i];
        addCurlNoise<false, 2>(d, place * octave.frequency + octave.shift, octave.slices, sum, none);
    }
    return sum * (share * stirring.strength);
}

HWY_INLINE Vec3<V> bounded(D d, const Vec3<V>& v)
{
    const V most = hn::Set(d, kMaxAirSpeed);
    const auto within = [&](V speed) HWY_ATTR { return hn::Min(hn::Max(speed, hn::Neg(most)), most); };
    return {within(v.x), within(v.y), within(v.z)};
}

void forcePlane(AirCells& cells, const AirStep& step, int k, const CurlAround& curl)
{
    const D d;
    const auto n = static_cast<std::size_t>(cells.grid.cells.x);
    for (int j = 0; j < cells.grid.cells.y; ++j) {
        const bool onGround = j == 0 && cells.borders.low[1] == Border::Solid;
        const std::size_t start = cells.column.at(0, j, k);
        const std::size_t inPlane = CurlPlane::at(cells.column, j);
        const glm::vec3 rowStart = cells.grid.centre({0, j, k});
        for (std::size_t i = 0; i < n; i += hn::Lanes(d)) {
            const std::size_t at = start + i;
            const V heat = hn::Load(d, cells.heat.data() + at);
            Vec3<V> v = load(d, cells.velocity.x, cells.velocity.y, cells.velocity.z, at) + step.windChange;
            v.y = v.y + heat * (step.dt * step.buoyancy);
            if (step.confinement > 0.0F) {
                v = v + confinement(d, curl, cells.column.row, step.confinement * step.dt, inPlane + i);
            }
            const Vec3<V> place{hn::Iota(d, static_cast<float>(i)) * cells.grid.cell + rowStart.x, hn::Set(d, rowStart.y), hn::Set(d, rowStart.z)};
            if (step.swirl.speed != 0.0F) {
                v = v + swirled(d, step.swirl, step.dt, place - step.swirl.place, v);
            }
            if (step.stirring.strength > 0.0F) {
                v = v + stirred(d, step.stirring, place, heat) * step.dt;
            }
            if (step.friction > 0.0F && (onGround || cells.hasObstacles())) {
                v = v * afterDrag(d, cells, step, onGround, v, at);
            }
            if (cells.hasObstacles()) {
                v = v * hn::Load(d, cells.fluid.data() + at);
            }
            store(bounded(d, v), cells.forced.x, cells.forced.y, cells.forced.z, at);
            hn::Store(heat * step.heatKept, d, cells.heat.data() + at);
        }
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(sourcePlane);
HWY_EXPORT(curlPlane);
HWY_EXPORT(forcePlane);

void addSource(AirCells& cells, const AirSource& source, int k)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(sourcePlane);
    kernel(cells, source, k);
}

void findCurl(const AirCells& cells, int k, CurlPlane& out)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(curlPlane);
    kernel(cells, k, out);
}

void addForces(AirCells& cells, const AirStep& step, int k, const CurlAround& curl)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(forcePlane);
    kernel(cells, step, k, curl);
}

} // namespace fumage
#endif
