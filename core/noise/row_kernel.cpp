#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/noise/row_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/math-inl.h"
#include "core/noise/lattice_hash.h"
#include "core/noise/row_kernel.h"
#include "core/noise/simplex-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;

/// Makes the standard deviation of one octave about 1/3, with the 2^-31 of the gradients; measured over 10^6 points.
constexpr float kGradientScale = 1.8F * 0x1p-31F;
constexpr float kSimplexScale = 90.0F * 0x1p-31F;

HWY_INLINE V mix(V a, V b, V t)
{
    return mulAdd(t, hn::Sub(b, a), a);
}

void gradientRow(const Octave& octave, int y, std::array<int, 2> layers, float fz, float weightZ, LatticeRow& row)
{
    const D d;
    const hn::RebindToUnsigned<D> du;
    const hn::RebindToSigned<D> di;
    const auto seed = hn::Set(du, octave.seed);
    const auto row0 = hn::Set(du, latticeRow(y, layers[0]));
    const auto row1 = hn::Set(du, latticeRow(y, layers[1]));
    const V t = hn::Set(d, weightZ);
    const auto column = hn::Set(du, kColumnPrime);
    const auto points = static_cast<std::size_t>(octave.period.x);
    const bool flat = weightZ == 0.0F;
    for (std::size_t i = 0; i < points; i += hn::Lanes(d)) {
        const auto linear = hn::Mul(hn::Add(hn::Iota(du, 0U), hn::Set(du, static_cast<std::uint32_t>(i))), column);
        const auto bits0 = latticeBits(du, hn::Add(linear, row0), seed);
        const auto component = [&](auto bits) { return hn::ConvertTo(d, hn::BitCast(di, bits)); };
        if (flat) {
            hn::StoreU(component(bits0), d, row.x.data() + i);
            hn::StoreU(component(hn::ShiftLeft<11>(bits0)), d, row.y.data() + i);
            hn::StoreU(hn::Mul(component(hn::ShiftLeft<22>(bits0)), hn::Set(d, fz)), d, row.z.data() + i);
            continue;
        }
        const auto bits1 = latticeBits(du, hn::Add(linear, row1), seed);
        hn::StoreU(mix(component(bits0), component(bits1), t), d, row.x.data() + i);
        hn::StoreU(mix(component(hn::ShiftLeft<11>(bits0)), component(hn::ShiftLeft<11>(bits1)), t), d, row.y.data() + i);
        const V z0 = hn::Mul(component(hn::ShiftLeft<22>(bits0)), hn::Set(d, fz));
        const V z1 = hn::Mul(component(hn::ShiftLeft<22>(bits1)), hn::Set(d, fz - 1.0F));
        hn::StoreU(mix(z0, z1, t), d, row.z.data() + i);
    }
    for (AlignedArray<float>* column0 : {&row.x, &row.y, &row.z}) {
        (*column0)[points] = (*column0)[0]; // the lattice repeats
    }
}

void gradientCoefficients(const LatticeRow& below, const LatticeRow& above, float fy, float weightY, float amplitude, int cells, RowCoefficients& out)
{
    const D d;
    const float* HWY_RESTRICT belowX = below.x.data();
    const float* HWY_RESTRICT belowY = below.y.data();
    const float* HWY_RESTRICT belowZ = below.z.data();
    const float* HWY_RESTRICT aboveX = above.x.data();
    const float* HWY_RESTRICT aboveY = above.y.data();
    const float* HWY_RESTRICT aboveZ = above.z.data();
    float* HWY_RESTRICT c0 = out.c0.data();
    float* HWY_RESTRICT c1 = out.c1.data();
    float* HWY_RESTRICT d0 = out.d0.data();
    float* HWY_RESTRICT d1 = out.d1.data();
    const V t = hn::Set(d, weightY);
    const V up = hn::Set(d, fy);
    const V down = hn::Set(d, fy - 1.0F);
    const V scale = hn::Set(d, amplitude * kGradientScale);
    const auto count = static_cast<std::size_t>(cells);
    for (std::size_t i = 0; i <= count; i += hn::Lanes(d)) {
        const V slope = mix(hn::Load(d, belowX + i), hn::Load(d, aboveX + i), t);
        const V low = mulAdd(hn::Load(d, belowY + i), up, hn::Load(d, belowZ + i));
        const V high = mulAdd(hn::Load(d, aboveY + i), down, hn::Load(d, aboveZ + i));
        hn::StoreU(hn::Mul(slope, scale), d, c1 + i);
        hn::StoreU(hn::Mul(mix(low, high, t), scale), d, c0 + i);
    }
    // The upper column of a cell is the lower one of the next, seen from the other side: d0 and d1 are the differences.
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const V nextC1 = hn::LoadU(d, c1 + i + 1);
        hn::StoreU(hn::Sub(hn::Sub(hn::LoadU(d, c0 + i + 1), nextC1), hn::LoadU(d, c0 + i)), d, d0 + i);
        hn::StoreU(hn::Sub(nextC1, hn::LoadU(d, c1 + i)), d, d1 + i);
    }
}

void addPixelRow(const RowPositions& positions, const RowCoefficients& coefficients, float* HWY_RESTRICT values)
{
    const D d;
    const hn::RebindToSigned<D> di;
    const std::size_t size = positions.cell.size();
    const std::int32_t* HWY_RESTRICT cells = positions.cell.data();
    const std::int32_t* HWY_RESTRICT lanes = positions.lane.data();
    const float* HWY_RESTRICT fraction = positions.fraction.data();
    const float* HWY_RESTRICT weight = positions.weight.data();
    const float* HWY_RESTRICT c0 = coefficients.c0.data();
    const float* HWY_RESTRICT c1 = coefficients.c1.data();
    const float* HWY_RESTRICT d0 = coefficients.d0.data();
    const float* HWY_RESTRICT d1 = coefficients.d1.data();
    const auto add = [&](std::size_t i, V k0, V k1, V e0, V e1) {
        const V f = hn::Load(d, fraction + i);
        const V low = mulAdd(k1, f, k0);
        const V rise = mulAdd(e1, f, e0);
        hn::Store(hn::Add(hn::Load(d, values + i), mulAdd(hn::Load(d, weight + i), rise, low)), d, values + i);
    };
    if (positions.uniform) {
        for (std::size_t i = 0; i < size; i += hn::Lanes(d)) {
            const std::int32_t cell = cells[i];
            add(i, hn::Set(d, c0[cell]), hn::Set(d, c1[cell]), hn::Set(d, d0[cell]), hn::Set(d, d1[cell]));
        }
        return;
    }
    for (std::size_t i = 0; i < size; i += hn::Lanes(d)) {
        // Cells along a row never skip one, so that a vector of pixels needs at most a vector of cells.
        const std::int32_t first = cells[i];
        const auto within = hn::Sub(hn::Load(di, lanes + i), hn::Set(di, lanes[i]));
        const auto order = hn::IndicesFromVec(d, within);
        const auto pick = [&](const float* column) { return hn::TableLookupLanes(hn::LoadU(d, column + first), order); };
        add(i, pick(c0), pick(c1), pick(d0), pick(d1));
    }
}

/// Doubled coordinate of the corner d away from position p, which is whole, brought into [0, 2 period).
template <class DI>
HWY_INLINE hn::VFromD<DI> wrappedCorner(DI di, V p, V d, int period)
{
    const D df;
    const auto doubled = hn::NearestInt(hn::Mul(hn::Set(df, 2.0F), hn::Sub(p, d)));
    const auto full = hn::Set(di, 2 * period);
    const auto zero = hn::Zero(di);
    const auto up = hn::Add(doubled, hn::IfThenElseZero(hn::Lt(doubled, zero), full));
    return hn::Sub(up, hn::IfThenElseZero(hn::Not(hn::Lt(up, full)), full));
}

void simplexRow(const Octave& octave, int size, float y, float z, float* values)
{
    const D d;
    const hn::RebindToSigned<D> di;
    const hn::RebindToUnsigned<D> du;
    const float step = static_cast<float>(octave.period.x) / static_cast<float>(size);
    const V scale = hn::Set(d, octave.amplitude * kSimplexScale);
    const V vy = hn::Set(d, y);
    const V vz = hn::Set(d, z);
    for (std::size_t i = 0; i < static_cast<std::size_t>(size); i += hn::Lanes(d)) {
        const V x = hn::Mul(hn::Add(hn::Iota(d, 0.5F), hn::Set(d, static_cast<float>(i))), hn::Set(d, step));
        const SimplexCorners<D> corners = simplexCorners(d, x, vy, vz);
        V sum = hn::Zero(d);
        for (int c = 0; c < 4; ++c) {
            const V dx = corners.dx[c];
            const V dy = corners.dy[c];
            const V dz = corners.dz[c];
            const auto px = hn::BitCast(du, wrappedCorner(di, x, dx, octave.period.x));
            const auto py = hn::BitCast(du, wrappedCorner(di, vy, dy, octave.period.y));
            const auto pz = hn::BitCast(du, wrappedCorner(di, vz, dz, octave.period.z));
            const auto linear = hn::Add(hn::Add(hn::Mul(px, hn::Set(du, kColumnPrime)), hn::Mul(py, hn::Set(du, kRowPrime))), hn::Mul(pz, hn::Set(du, kLayerPrime)));
            const auto bits = latticeBits(du, linear, hn::Set(du, octave.seed));
            const V gx = hn::ConvertTo(d, hn::BitCast(di, bits));
            const V gy = hn::ConvertTo(d, hn::BitCast(di, hn::ShiftLeft<11>(bits)));
            const V gz = hn::ConvertTo(d, hn::BitCast(di, hn::ShiftLeft<22>(bits)));
            const V r2 = hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(dz, dz));
            const V t = hn::Max(hn::Zero(d), hn::Sub(hn::Set(d, 0.5F), r2));
            const V t2 = hn::Mul(t, t);
            const V dot = hn::Add(hn::Add(hn::Mul(dx, gx), hn::Mul(dy, gy)), hn::Mul(dz, gz));
            sum = hn::Add(sum, hn::Mul(hn::Mul(t2, t2), dot));
        }
        hn::StoreU(hn::Add(hn::LoadU(d, values + i), hn::Mul(sum, scale)), d, values + i);
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(gradientRow);
HWY_EXPORT(gradientCoefficients);
HWY_EXPORT(addPixelRow);
HWY_EXPORT(simplexRow);

RowPositions rowPositions(int size, int cells, Interpolation kind, bool squareWeight)
{
    const std::size_t padded = roundUp(static_cast<std::size_t>(size), RowPositions::kBlock);
    RowPositions out;
    out.fraction.resize(padded);
    out.weight.resize(padded);
    out.cell.resize(padded);
    out.lane.resize(padded);
    out.uniform = true;
    const double scale = static_cast<double>(cells) / size;
    for (std::size_t i = 0; i < padded; ++i) {
        const std::size_t pixel = std::min(i, static_cast<std::size_t>(size) - 1);
        const double x = (static_cast<double>(pixel) + 0.5) * scale;
        const auto cell = static_cast<std::int32_t>(x);
        out.cell[i] = cell;
        out.lane[i] = cell - out.cell[i / RowPositions::kBlock * RowPositions::kBlock];
        out.uniform = out.uniform && out.lane[i] == 0;
        out.fraction[i] = static_cast<float>(x - cell);
        out.weight[i] = squareWeight ? out.fraction[i] * out.fraction[i] : interpolationWeight(kind, out.fraction[i]);
    }
    return out;
}

void fillGradientRow(const Octave& octave, int y, std::array<int, 2> layers, float fz, float weightZ, LatticeRow& row)
{
    HWY_DYNAMIC_DISPATCH(gradientRow)
    (octave, y, layers, fz, weightZ, row);
}

void fillGradientCoefficients(const LatticeRow& below, const LatticeRow& above, float fy, float weightY, float amplitude, int cells, RowCoefficients& out)
{
    HWY_DYNAMIC_DISPATCH(gradientCoefficients)
    (below, above, fy, weightY, amplitude, cells, out);
}

void addRow(const RowPositions& positions, const RowCoefficients& coefficients, float* values)
{
    HWY_DYNAMIC_DISPATCH(addPixelRow)
    (positions, coefficients, values);
}

void addSimplexRow(const Octave& octave, int size, float y, float z, float* values)
{
    HWY_DYNAMIC_DISPATCH(simplexRow)
    (octave, size, y, z, values);
}

} // namespace fumage
#endif
