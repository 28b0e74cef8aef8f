#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/noise/row_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/math-inl.h"
#include "core/noise/row_cells-inl.h"
#include "core/noise/row_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = RowTag;
using V = RowVec;

/// Makes the standard deviation of one octave about 1/3, with the 2^-31 of the gradients; measured over 10^6 points.
constexpr float kGradientScale = 1.8F * 0x1p-31F;

HWY_INLINE V mix(V a, V b, V t)
{
    return t * (b - a) + a;
}

void gradientRow(
    const Octave& octave, int y, std::array<int, 2> planes, float fz, float weightZ, const GradientRow& row)
{
    const D d;
    const hn::RebindToSigned<D> di;
    const V t = hn::Set(d, weightZ);
    const auto points = static_cast<std::size_t>(octave.period.x);
    const bool flat = weightZ == 0.0F;
    const auto component = [&](auto bits) HWY_ATTR { return hn::ConvertTo(d, hn::BitCast(di, bits)); };
    for (std::size_t i = 0; i < points; i += hn::Lanes(d)) {
        const auto bits0 = rowBits(octave, i, latticeRow(y, planes[0]));
        if (flat) {
            hn::StoreU(component(bits0), d, row.x + i);
            hn::StoreU(component(hn::ShiftLeft<11>(bits0)), d, row.y + i);
            hn::StoreU(component(hn::ShiftLeft<22>(bits0)) * fz, d, row.z + i);
            continue;
        }
        const auto bits1 = rowBits(octave, i, latticeRow(y, planes[1]));
        hn::StoreU(mix(component(bits0), component(bits1), t), d, row.x + i);
        hn::StoreU(mix(component(hn::ShiftLeft<11>(bits0)), component(hn::ShiftLeft<11>(bits1)), t), d, row.y + i);
        const V z0 = component(hn::ShiftLeft<22>(bits0)) * fz;
        const V z1 = component(hn::ShiftLeft<22>(bits1)) * (fz - 1.0F);
        hn::StoreU(mix(z0, z1, t), d, row.z + i);
    }
    for (float* values : {row.x, row.y, row.z}) {
        repeatEnds(values, points);
    }
}

void gradientCoefficients(const GradientRow& below, const GradientRow& above, float fy, float weightY, float amplitude,
    int cells, const RowCoefficients& out)
{
    const D d;
    const float* HWY_RESTRICT belowX = below.x;
    const float* HWY_RESTRICT belowY = below.y;
    const float* HWY_RESTRICT belowZ = below.z;
    const float* HWY_RESTRICT aboveX = above.x;
    const float* HWY_RESTRICT aboveY = above.y;
    const float* HWY_RESTRICT aboveZ = above.z;
    float* HWY_RESTRICT c0 = out.c0;
    float* HWY_RESTRICT c1 = out.c1;
    float* HWY_RESTRICT d0 = out.d0;
    float* HWY_RESTRICT d1 = out.d1;
    const V t = hn::Set(d, weightY);
    const V up = hn::Set(d, fy);
    const V down = hn::Set(d, fy - 1.0F);
    const V scale = hn::Set(d, amplitude * kGradientScale);
    const auto count = static_cast<std::size_t>(cells);
    for (std::size_t i = 0; i <= count; i += hn::Lanes(d)) {
        const V slope = mix(hn::Load(d, belowX + i), hn::Load(d, aboveX + i), t);
        const V low = hn::Load(d, belowY + i) * up + hn::Load(d, belowZ + i);
        const V high = hn::Load(d, aboveY + i) * down + hn::Load(d, aboveZ + i);
        hn::StoreU(slope * scale, d, c1 + i);
        hn::StoreU(mix(low, high, t) * scale, d, c0 + i);
    }
    // The upper column of a cell is the lower one of the next, seen from the other side: d0 and d1 are the differences.
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const V nextC1 = hn::LoadU(d, c1 + i + 1);
        hn::StoreU((hn::LoadU(d, c0 + i + 1) - nextC1) - hn::LoadU(d, c0 + i), d, d0 + i);
        hn::StoreU(nextC1 - hn::LoadU(d, c1 + i), d, d1 + i);
    }
}

void valueRow(const Octave& octave, int y, int z, float* HWY_RESTRICT values)
{
    const D d;
    const hn::RebindToSigned<D> di;
    const auto points = static_cast<std::size_t>(octave.period.x);
    for (std::size_t i = 0; i < points; i += hn::Lanes(d)) {
        const auto bits = hn::ShiftRight<8>(rowBits(octave, i, latticeRow(y, z)));
        hn::Store(hn::ConvertTo(d, hn::BitCast(di, bits)) * 0x1p-24F, d, values + i);
    }
    repeatEnds(values, points);
}

void smoothRow(const std::array<const float*, 3>& rows, float amount, int cells, float* HWY_RESTRICT values)
{
    const D d;
    for (std::size_t i = 0; i < static_cast<std::size_t>(cells); i += hn::Lanes(d)) {
        V mean = hn::Zero(d);
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t column = 0; column < 3; ++column) {
                mean = (kSmoothKernel[row] * kSmoothKernel[column]) * hn::LoadU(d, rows[row] + i + column - 1) + mean;
            }
        }
        const V plain = hn::Load(d, rows[1] + i);
        hn::Store(amount * (mean - plain) + plain, d, values + i);
    }
}

/// interpolateCubic() at a place, or between two values by a weight.
template <bool kCubic>
HWY_INLINE V interpolate(const V* values, V t)
{
    if constexpr (kCubic) {
        const V drop = values[0] - values[1];
        const V p = (values[3] - values[2]) - drop;
        const V q = drop - p;
        const V r = values[2] - values[0];
        return ((p * t + q) * t + r) * t + values[1];
    } else {
        return mix(values[0], values[1], t);
    }
}

/// Values at the lattice columns of a row of pixels, where only y and z need interpolation; signed, so that they are
/// about 0.
template <bool kCubic, bool kFlat>
HWY_INLINE void valuesAtColumns(const ValueRows& in, float amplitude, std::size_t points, float* HWY_RESTRICT columns)
{
    constexpr std::size_t kRows = kCubic ? 4 : 2;
    constexpr std::size_t kPlanes = kFlat ? 1 : kRows;
    const D d;
    const std::array<std::array<const float*, 4>, 4> rows = in.rows;
    const V alongY = hn::Set(d, in.alongY);
    const V alongZ = hn::Set(d, in.alongZ);
    for (std::size_t i = 0; i < points; i += hn::Lanes(d)) {
        V planes[kRows];
        for (std::size_t k = 0; k < kPlanes; ++k) {
            V values[kRows];
            for (std::size_t j = 0; j < kRows; ++j) {
                values[j] = hn::Load(d, rows[k][j] + i);
            }
            planes[k] = interpolate<kCubic>(values, alongY);
        }
        const V value = kFlat ? planes[0] : interpolate<kCubic>(planes, alongZ);
        hn::Store((2.0F * value - 1.0F) * amplitude, d, columns + i);
    }
    repeatEnds(columns, points);
}

/// The polynomial of each cell along x; see RowCoefficients.
template <bool kCubic>
HWY_INLINE void valuePolynomials(std::size_t cells, const RowCoefficients& out)
{
    const D d;
    const float* HWY_RESTRICT values = out.c0;
    float* HWY_RESTRICT c1 = out.c1;
    float* HWY_RESTRICT d0 = out.d0;
    float* HWY_RESTRICT d1 = out.d1;
    for (std::size_t i = 0; i < cells; i += hn::Lanes(d)) {
        const V below = hn::Load(d, values + i);
        const V above = hn::LoadU(d, values + i + 1);
        if constexpr (kCubic) {
            const V before = hn::LoadU(d, values + i - 1);
            const V drop = before - below;
            const V p = (hn::LoadU(d, values + i + 2) - above) - drop;
            hn::Store(above - before, d, c1 + i);
            hn::Store(drop - p, d, d0 + i);
            hn::Store(p, d, d1 + i);
        } else {
            hn::Store(above - below, d, d0 + i);
        }
    }
}

void valueCoefficients(const ValueRows& rows, float amplitude, int cells, const RowCoefficients& out)
{
    const auto count = static_cast<std::size_t>(cells);
    if (rows.cubic) {
        rows.flat ? valuesAtColumns<true, true>(rows, amplitude, count, out.c0)
                  : valuesAtColumns<true, false>(rows, amplitude, count, out.c0);
        valuePolynomials<true>(count, out);
    } else {
        rows.flat ? valuesAtColumns<false, true>(rows, amplitude, count, out.c0)
                  : valuesAtColumns<false, false>(rows, amplitude, count, out.c0);
        valuePolynomials<false>(count, out);
    }
}

void addPixelRow(const RowPositions& positions, const RowCoefficients& coefficients, float* HWY_RESTRICT values)
{
    struct Place {
        V fraction;
        V weight;
    };
    const D d;
    const std::array<const float*, 4> columns{coefficients.c0, coefficients.c1, coefficients.d0, coefficients.d1};
    const float* HWY_RESTRICT fraction = positions.fraction.data();
    const float* HWY_RESTRICT weight = positions.weight.data();
    const auto place = [=](std::size_t j) HWY_ATTR {
        return Place{hn::Load(d, fraction + j), hn::Load(d, weight + j)};
    };
    addCells(positions, columns, values, place, [](const Place& at, const V* c) HWY_ATTR {
        const V low = c[1] * at.fraction + c[0];
        const V rise = c[3] * at.fraction + c[2];
        return at.weight * rise + low;
    });
}

void addFlatPixelRow(const RowPositions& positions, const RowCoefficients& coefficients, float* HWY_RESTRICT values)
{
    const D d;
    const std::array<const float*, 2> columns{coefficients.c0, coefficients.d0};
    const float* HWY_RESTRICT weight = positions.weight.data();
    const auto place = [=](std::size_t j) HWY_ATTR { return hn::Load(d, weight + j); };
    addCells(positions, columns, values, place, [](V w, const V* c) HWY_ATTR { return w * c[1] + c[0]; });
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(gradientRow);
HWY_EXPORT(gradientCoefficients);
HWY_EXPORT(valueRow);
HWY_EXPORT(smoothRow);
HWY_EXPORT(valueCoefficients);
HWY_EXPORT(addPixelRow);
HWY_EXPORT(addFlatPixelRow);

void fillGradientRow(
    const Octave& octave, int y, std::array<int, 2> planes, float fz, float weightZ, const GradientRow& row)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(gradientRow);
    kernel(octave, y, planes, fz, weightZ, row);
}

void fillGradientCoefficients(const GradientRow& below, const GradientRow& above, float fy, float weightY,
    float amplitude, int cells, const RowCoefficients& out)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(gradientCoefficients);
    kernel(below, above, fy, weightY, amplitude, cells, out);
}

void fillValueRow(const Octave& octave, int y, int z, float* values)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(valueRow);
    kernel(octave, y, z, values);
}

void smoothValueRow(const std::array<const float*, 3>& rows, float amount, int cells, float* values)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(smoothRow);
    kernel(rows, amount, cells, values);
}

void fillValueCoefficients(const ValueRows& rows, float amplitude, int cells, const RowCoefficients& out)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(valueCoefficients);
    kernel(rows, amplitude, cells, out);
}

void addRow(const RowPositions& positions, const RowCoefficients& coefficients, float* values)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(addPixelRow);
    kernel(positions, coefficients, values);
}

void addFlatRow(const RowPositions& positions, const RowCoefficients& coefficients, float* values)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(addFlatPixelRow);
    kernel(positions, coefficients, values);
}

} // namespace fumage
#endif
