#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/noise/simplex_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/math-inl.h"
#include "core/noise/row_cells-inl.h"
#include "core/noise/simplex_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = RowTag;
using V = RowVec;

/// Makes the standard deviation of one octave about 1/3, with the 2^-31 of the gradients; measured over 10^6 points.
constexpr float kSimplexScale = 90.0F * 0x1p-31F;

void simplexLine(const Octave& octave, const SimplexLine& line, const GradientRow& out)
{
    const D d;
    const hn::RebindToSigned<D> di;
    const hn::RebindToUnsigned<D> du;
    const V scale = hn::Set(d, octave.amplitude * kSimplexScale);
    const auto points = static_cast<std::size_t>(octave.period.x);
    const std::uint32_t start = latticeRow(line.y, line.z) + latticeColumn(line.between ? 1 : 0);
    const auto component = [&](auto bits) HWY_ATTR { return hn::ConvertTo(d, hn::BitCast(di, bits)) * scale; };
    for (std::size_t i = 0; i < points; i += hn::Lanes(d)) {
        const auto columns = hn::Iota(du, 0U) + hn::Set(du, static_cast<std::uint32_t>(i));
        const auto linear = columns * hn::Set(du, 2 * kColumnPrime) + hn::Set(du, start);
        const auto bits = latticeBits(linear, hn::Set(du, octave.seed));
        hn::Store(component(bits), d, out.x + i);
        hn::Store(component(hn::ShiftLeft<11>(bits)), d, out.y + i);
        hn::Store(component(hn::ShiftLeft<22>(bits)), d, out.z + i);
    }
    repeatEnds(out.x, points);
}

void simplexHeights(const GradientRow& line, float dy, float dz, int points, float* HWY_RESTRICT heights)
{
    const D d;
    const float* HWY_RESTRICT y = line.y;
    const float* HWY_RESTRICT z = line.z;
    for (std::size_t i = 0; i < static_cast<std::size_t>(points); i += hn::Lanes(d)) {
        hn::Store(hn::Load(d, y + i) * dy + hn::Load(d, z + i) * dz, d, heights + i);
    }
    repeatEnds(heights, static_cast<std::size_t>(points));
}

/// The way along x from a lattice point to pixels, and t^4 there.
struct Way {
    V dx;
    V fourth;
};

HWY_INLINE Way wayTo(V dx, V reach)
{
    const D d;
    const V t = hn::Max(hn::Zero(d), reach - dx * dx);
    const V t2 = t * t;
    return {dx, t2 * t2};
}

/// t^4 (slope dx + height)
HWY_INLINE V pointNoise(const Way& way, V slope, V height)
{
    return way.fourth * (slope * way.dx + height);
}

void addPairRow(
    const RowPositions& positions, const float* slopes, const float* heights, float reach, float* HWY_RESTRICT values)
{
    struct Ways {
        Way below;
        Way above;
    };
    const D d;
    const std::array<const float*, 4> columns{slopes, heights, slopes + 1, heights + 1};
    const float* HWY_RESTRICT fraction = positions.fraction.data();
    const auto ways = [=](std::size_t j) HWY_ATTR {
        const V dx = hn::Load(d, fraction + j);
        return Ways{wayTo(dx, hn::Set(d, reach)), wayTo(dx - 1.0F, hn::Set(d, reach))};
    };
    addCells(positions, columns, values, ways, [](const Ways& at, const V* c) HWY_ATTR {
        return pointNoise(at.below, c[0], c[1]) + pointNoise(at.above, c[2], c[3]);
    });
}

void addNearestRow(
    const RowPositions& positions, const float* slopes, const float* heights, float reach, float* HWY_RESTRICT values)
{
    const D d;
    const std::array<const float*, 2> columns{slopes, heights};
    const float* HWY_RESTRICT fraction = positions.fraction.data();
    const auto way = [=](std::size_t j) HWY_ATTR { return wayTo(hn::Load(d, fraction + j) - 0.5F, hn::Set(d, reach)); };
    addCells(
        positions, columns, values, way, [](const Way& at, const V* c) HWY_ATTR { return pointNoise(at, c[0], c[1]); });
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(simplexLine);
HWY_EXPORT(simplexHeights);
HWY_EXPORT(addPairRow);
HWY_EXPORT(addNearestRow);

void fillSimplexLine(const Octave& octave, const SimplexLine& line, const GradientRow& out)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(simplexLine);
    kernel(octave, line, out);
}

void fillSimplexHeights(const GradientRow& line, float dy, float dz, int points, float* heights)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(simplexHeights);
    kernel(line, dy, dz, points, heights);
}

void addPairsOfPoints(
    const RowPositions& positions, const float* slopes, const float* heights, float reach, float* values)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(addPairRow);
    kernel(positions, slopes, heights, reach, values);
}

void addNearestPoints(
    const RowPositions& positions, const float* slopes, const float* heights, float reach, float* values)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(addNearestRow);
    kernel(positions, slopes, heights, reach, values);
}

} // namespace fumage
#endif
