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
#include <numeric>

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
            hn::StoreU(component(bits0), d, row.x + i);
            hn::StoreU(component(hn::ShiftLeft<11>(bits0)), d, row.y + i);
            hn::StoreU(hn::Mul(component(hn::ShiftLeft<22>(bits0)), hn::Set(d, fz)), d, row.z + i);
            continue;
        }
        const auto bits1 = latticeBits(du, hn::Add(linear, row1), seed);
        hn::StoreU(mix(component(bits0), component(bits1), t), d, row.x + i);
        hn::StoreU(mix(component(hn::ShiftLeft<11>(bits0)), component(hn::ShiftLeft<11>(bits1)), t), d, row.y + i);
        const V z0 = hn::Mul(component(hn::ShiftLeft<22>(bits0)), hn::Set(d, fz));
        const V z1 = hn::Mul(component(hn::ShiftLeft<22>(bits1)), hn::Set(d, fz - 1.0F));
        hn::StoreU(mix(z0, z1, t), d, row.z + i);
    }
    for (float* component : {row.x, row.y, row.z}) {
        component[points] = component[0]; // the lattice repeats
    }
}

void gradientCoefficients(const LatticeRow& below, const LatticeRow& above, float fy, float weightY, float amplitude, int cells, RowCoefficients& out)
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

/// Adds a block of kBlock pixels after the other. add(i, j, cell): a vector of pixels from i on, which lie at j in the repeat, in or after the cell.
template <class Add>
HWY_INLINE void forVectors(const RowPositions& positions, const Add& add)
{
    const D d;
    const std::size_t repeat = positions.fraction.size();
    const std::size_t blocks = positions.cell.size();
    const std::int32_t* HWY_RESTRICT cells = positions.cell.data();
    std::size_t j = 0;
    for (std::size_t block = 0; block < blocks; ++block) {
        const std::int32_t cell = cells[block];
        for (std::size_t i = 0; i < RowPositions::kBlock; i += hn::Lanes(d)) {
            add(block * RowPositions::kBlock + i, j + i, cell);
        }
        j += RowPositions::kBlock;
        j = j == repeat ? 0 : j;
    }
}

void addPixelRow(const RowPositions& positions, const RowCoefficients& coefficients, float* HWY_RESTRICT values)
{
    const D d;
    const hn::RebindToSigned<D> di;
    const std::int32_t* HWY_RESTRICT lanes = positions.lane.data();
    const float* HWY_RESTRICT fraction = positions.fraction.data();
    const float* HWY_RESTRICT weight = positions.weight.data();
    const float* HWY_RESTRICT c0 = coefficients.c0;
    const float* HWY_RESTRICT c1 = coefficients.c1;
    const float* HWY_RESTRICT d0 = coefficients.d0;
    const float* HWY_RESTRICT d1 = coefficients.d1;
    const auto add = [&](std::size_t i, V f, V w, V k0, V k1, V e0, V e1) HWY_ATTR {
        const V low = mulAdd(k1, f, k0);
        const V rise = mulAdd(e1, f, e0);
        hn::Store(hn::Add(hn::Load(d, values + i), mulAdd(w, rise, low)), d, values + i);
    };
    // Cells along a row never skip one, so that a vector of pixels needs at most a vector of cells.
    const auto pickAndAdd = [&](std::size_t i, V f, V w, const float* HWY_RESTRICT* columns, auto order) HWY_ATTR {
        const auto pick = [&](const float* column) HWY_ATTR { return hn::TableLookupLanes(hn::LoadU(d, column), order); };
        add(i, f, w, pick(columns[0]), pick(columns[1]), pick(columns[2]), pick(columns[3]));
    };
    if (positions.uniform) {
        forVectors(positions, [&](std::size_t i, std::size_t j, std::int32_t cell) HWY_ATTR {
            add(i, hn::Load(d, fraction + j), hn::Load(d, weight + j), hn::Set(d, c0[cell]), hn::Set(d, c1[cell]), hn::Set(d, d0[cell]), hn::Set(d, d1[cell]));
        });
    } else if (positions.fraction.size() == hn::Lanes(d)) {
        // Every vector of the row lies alike in its cells.
        const V f = hn::Load(d, fraction);
        const V w = hn::Load(d, weight);
        const auto order = hn::IndicesFromVec(d, hn::Load(di, lanes));
        forVectors(positions, [&](std::size_t i, std::size_t, std::int32_t cell) HWY_ATTR {
            const float* HWY_RESTRICT columns[] = {c0 + cell, c1 + cell, d0 + cell, d1 + cell};
            pickAndAdd(i, f, w, columns, order);
        });
    } else {
        forVectors(positions, [&](std::size_t i, std::size_t j, std::int32_t cell) HWY_ATTR {
            const std::int32_t first = cell + lanes[j];
            const auto order = hn::IndicesFromVec(d, hn::Sub(hn::Load(di, lanes + j), hn::Set(di, lanes[j])));
            const float* HWY_RESTRICT columns[] = {c0 + first, c1 + first, d0 + first, d1 + first};
            pickAndAdd(i, hn::Load(d, fraction + j), hn::Load(d, weight + j), columns, order);
        });
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
    const bool wholePixels = size % cells == 0;
    const std::size_t repeat = wholePixels ? std::min(padded, std::lcm(static_cast<std::size_t>(size / cells), RowPositions::kBlock)) : padded;
    RowPositions out;
    out.fraction.resize(repeat);
    out.weight.resize(repeat);
    out.lane.resize(repeat);
    out.uniform = true;
    const double scale = static_cast<double>(cells) / size;
    const auto positionOf = [&](std::size_t i) { return (static_cast<double>(std::min(i, static_cast<std::size_t>(size) - 1)) + 0.5) * scale; };
    for (std::size_t i = 0; i < padded; i += RowPositions::kBlock) {
        out.cell.push_back(static_cast<std::int32_t>(positionOf(i)));
    }
    for (std::size_t i = 0; i < repeat; ++i) {
        const double x = positionOf(i);
        const auto cell = static_cast<std::int32_t>(x);
        out.lane[i] = cell - out.cell[i / RowPositions::kBlock];
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
