#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/flow/source_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/math-inl.h"
#include "core/flow/source_kernel.h"
#include "core/noise/simplex-inl.h"

#include <numeric>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::CappedTag<float, kAirLanes>;
using V = hn::Vec<D>;

/// 1 inside, 0 outside, smooth over a width around the border.
/// @param inside distance from the border, m
HWY_INLINE V covered(D d, V inside, float width)
{
    return smoothStep(clamp01(d, inside * (1.0F / width) + 0.5F));
}

HWY_INLINE void addOctave(D d, const AirOctave& octave, const Vec3<V>& away, Vec3<V>& to)
{
    Vec3<V> none = uniform(hn::Zero(d));
    addCurlNoise<false, 2>(d, away * octave.frequency + octave.shift, octave.slices, to, none);
}

/// Noise at a place: of the rim in x, of the speed in y, and in z what the heat has of it.
HWY_INLINE Vec3<V> rimNoise(D d, const AirSource& source, const Vec3<V>& away)
{
    Vec3<V> sum = uniform(hn::Zero(d));
    for (const AirOctave& octave : source.rim) {
        addOctave(d, octave, away, sum);
    }
    return sum;
}

/// How hot what comes out at a place is, over the mean: its noise is the rim's and that of an octave more.
/// @param rim z of rimNoise()
HWY_INLINE V heatAt(D d, const AirSource& source, const Vec3<V>& away, V rim)
{
    if (source.unevenness > 0.0F) {
        Vec3<V> small = uniform(hn::Zero(d));
        addOctave(d, source.billow, away, small);
        rim = rim + small.z;
    }
    return hn::Max(1.0F + source.unevenness * rim, hn::Zero(d));
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

/// How bright the picture of a source is at places on it, 0 to 1.
HWY_INLINE V brightness(D d, const AirSource& source, V across, V along)
{
    if (source.picture.empty()) {
        return hn::Set(d, 1.0F);
    }
    HWY_ALIGN float x[kAirLanes];
    HWY_ALIGN float y[kAirLanes];
    hn::Store(across / hn::Set(d, 2.0F * source.reach.x) + 0.5F, d, x);
    hn::Store(along / hn::Set(d, 2.0F * source.reach.y) + 0.5F, d, y);
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
        x[lane] = source.picture.coverAt(x[lane], y[lane]);
    }
    return hn::Load(d, x);
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
        return ends * brightness(d, source, across, along)
            * covered(d, hn::Min(edge * source.reach.x - hn::Abs(across), edge * source.reach.y - hn::Abs(along)),
                source.softness);
    }
    return ends * covered(d, edge * source.reach.x - hn::Sqrt(across * across + along * along), source.softness);
}

/// Middle of cell (0, j, k), from the source.
HWY_INLINE glm::vec3 rowFromSource(const AirCells& cells, const AirSource& source, int j, int k)
{
    return cells.grid.corner + cells.grid.cell * (glm::vec3(0.0F, static_cast<float>(j), static_cast<float>(k)) + 0.5F)
        - source.place;
}

/// Places within the source that fill it evenly, for means.
constexpr std::size_t kPlaces = 256;

float meanOfUnevenness(const AirSource& source)
{
    const D d;
    // Multiples of powers of the root of x^4 = x + 1 fill a cube evenly (Roberts 2018).
    const auto spread = [&](std::size_t i, float step) HWY_ATTR {
        const V at = hn::Iota(d, static_cast<float>(i)) * step;
        return 2.0F * (at - hn::Floor(at)) - 1.0F;
    };
    HWY_ALIGN float heat[kPlaces];
    HWY_ALIGN float inside[kPlaces];
    const bool isBall = source.shape == EmitterShape::Sphere;
    for (std::size_t i = 0; i < kPlaces; i += hn::Lanes(d)) {
        const V x = spread(i, 0.81917251F);
        const V y = spread(i, 0.67104361F);
        const V z = spread(i, 0.54970048F);
        const V up = isBall ? z * source.reach.x : (0.5F * z + 0.5F) * source.depth;
        const Vec3<V> away =
            (x * source.reach.x) * source.basis.across + (y * source.reach.y) * source.basis.along + up * source.normal;
        const V given = heatAt(d, source, away, rimNoise(d, source, away).z);
        const V distance2 = isBall ? x * x + y * y + z * z : x * x + y * y;
        const bool isCube = source.shape == EmitterShape::Rectangle;
        const V counts =
            isCube ? hn::Set(d, 1.0F) : hn::IfThenElseZero(hn::Lt(distance2, hn::Set(d, 1.0F)), hn::Set(d, 1.0F));
        hn::Store(counts, d, inside + i);
        hn::Store(counts * given, d, heat + i);
    }
    return static_cast<float>(
        std::accumulate(heat, heat + kPlaces, 0.0) / std::accumulate(inside, inside + kPlaces, 0.0));
}

void sourcePlane(AirCells& cells, const AirSource& source, int k)
{
    const D d;
    for (int j = source.first.y; j < source.last.y; ++j) {
        const glm::vec3 rowStart = rowFromSource(cells, source, j, k);
        const std::size_t row = cells.column.at(0, j, k);
        for (auto i = static_cast<std::size_t>(source.first.x); i < static_cast<std::size_t>(source.last.x);
             i += hn::Lanes(d)) {
            const std::size_t at = row + i;
            const Vec3<V> away{hn::Iota(d, static_cast<float>(i)) * cells.grid.cell + rowStart.x,
                hn::Set(d, rowStart.y), hn::Set(d, rowStart.z)};
            const V ends = betweenEnds(d, source, away);
            if (hn::AllFalse(d, hn::Gt(ends, hn::Zero(d)))) {
                continue;
            }
            const Vec3<V> noise = rimNoise(d, source, away);
            const V cover = coverage(d, source, away, ends, noise.x);
            // A cell that it does not reach stays as it is, to the sign of a zero, whatever lies beside it in a vector.
            const auto reached = hn::Gt(cover, hn::Zero(d));
            if (hn::AllFalse(d, reached)) {
                continue; // most of the cells that a rim may reach it does not
            }
            const V heat = hn::Load(d, cells.heat.data() + at);
            const V given = heatAt(d, source, away, noise.z) * source.heat;
            hn::Store(hn::IfThenElse(reached, hn::Max(heat, cover * given), heat), d, cells.heat.data() + at);
            const Vec3<V> v = load(d, cells.velocity.x, cells.velocity.y, cells.velocity.z, at);
            // What comes out is as uneven as its rim, and blown along by the air that it comes into.
            const V lacking = source.speed * (1.0F + source.raggedness * noise.y) - dot(v, source.normal);
            const Vec3<V> blown = v + (lacking * cover * source.relaxation) * source.normal;
            store(Vec3<V>{hn::IfThenElse(reached, blown.x, v.x), hn::IfThenElse(reached, blown.y, v.y),
                      hn::IfThenElse(reached, blown.z, v.z)},
                cells.velocity.x, cells.velocity.y, cells.velocity.z, at);
            const V added = cover * (source.expansion * cells.grid.cell);
            hn::Store(hn::Load(d, cells.divergence.data() + at) + added, d, cells.divergence.data() + at);
        }
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(meanOfUnevenness);
HWY_EXPORT(sourcePlane);

float meanUnevenness(const AirSource& source)
{
    return HWY_DYNAMIC_DISPATCH(meanOfUnevenness)(source);
}

void addSource(AirCells& cells, const AirSource& source, int k)
{
    if (!source.acts || k < source.first.z || k >= source.last.z) {
        return;
    }
    const auto kernel = HWY_DYNAMIC_DISPATCH(sourcePlane);
    kernel(cells, source, k);
}

} // namespace fumage
#endif
