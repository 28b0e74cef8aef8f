// Included once per SIMD target: rows of lattice points, and what is constant along their cells brought to pixels.

#if defined(FUMAGE_ROW_CELLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_ROW_CELLS_INL_H
#undef FUMAGE_ROW_CELLS_INL_H
#else
#define FUMAGE_ROW_CELLS_INL_H
#endif

#include "core/noise/fractal.h"
#include "core/noise/lattice_hash.h"
#include "core/noise/row_positions.h"
#include "core/noise/simplex-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using RowTag = hn::ScalableTag<float>;
using RowVec = hn::Vec<RowTag>;

/// Random bits of the lattice points of a row from i on, without a wrap: column + row is the linear hash.
HWY_INLINE hn::Vec<hn::RebindToUnsigned<RowTag>> rowBits(const Octave& octave, std::size_t i, std::uint32_t row)
{
    const hn::RebindToUnsigned<RowTag> du;
    const auto columns = hn::Add(hn::Iota(du, 0U), hn::Set(du, static_cast<std::uint32_t>(i)));
    return latticeBits(
        hn::Add(hn::Mul(columns, hn::Set(du, kColumnPrime)), hn::Set(du, row)), hn::Set(du, octave.seed));
}

/// The lattice repeats.
HWY_INLINE void repeatEnds(float* row, std::size_t points)
{
    row[-1] = row[points - 1];
    row[points] = row[0];
    row[points + 1] = row[1 % points];
}

/// Goes through a row in blocks of kBlock pixels. add(i, j, cell): a vector of pixels from i on, which lie at j in the
/// repeat, in or after the cell.
template <class Add>
HWY_INLINE void forVectors(const RowPositions& positions, const Add& add)
{
    const RowTag d;
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

/// Adds noise(place(j), c) to every pixel of a row: j is where it lies in the repeat, c what the columns hold for its
/// cell.
template <std::size_t kColumns, class Place, class Noise>
HWY_INLINE void addCells(const RowPositions& positions, const std::array<const float*, kColumns>& columns,
    float* HWY_RESTRICT values, const Place& place, const Noise& noise)
{
    const RowTag d;
    const hn::RebindToSigned<RowTag> di;
    const std::int32_t* HWY_RESTRICT lanes = positions.lane.data();
    const auto add = [&](std::size_t i, const auto& at, const auto& valueOf) HWY_ATTR {
        RowVec c[kColumns];
        for (std::size_t k = 0; k < kColumns; ++k) {
            c[k] = valueOf(columns[k]);
        }
        hn::Store(hn::Add(hn::Load(d, values + i), noise(at, c)), d, values + i);
    };
    if (positions.uniform) {
        forVectors(positions, [&](std::size_t i, std::size_t j, std::int32_t cell) HWY_ATTR {
            add(i, place(j), [&](const float* HWY_RESTRICT column) HWY_ATTR { return hn::Set(d, column[cell]); });
        });
    } else if (positions.fraction.size() == hn::Lanes(d)) {
        // Every vector of the row lies alike in its cells, which never skip one: a vector of pixels needs at most a
        // vector of cells.
        const auto order = hn::IndicesFromVec(d, hn::Load(di, lanes));
        const auto at = place(0);
        forVectors(positions, [&](std::size_t i, std::size_t, std::int32_t cell) HWY_ATTR {
            add(i, at, [&](const float* HWY_RESTRICT column) HWY_ATTR {
                return hn::TableLookupLanes(hn::LoadU(d, column + cell), order);
            });
        });
    } else {
        forVectors(positions, [&](std::size_t i, std::size_t j, std::int32_t cell) HWY_ATTR {
            const std::int32_t first = cell + lanes[j];
            const auto order = hn::IndicesFromVec(d, hn::Sub(hn::Load(di, lanes + j), hn::Set(di, lanes[j])));
            add(i, place(j), [&](const float* HWY_RESTRICT column) HWY_ATTR {
                return hn::TableLookupLanes(hn::LoadU(d, column + first), order);
            });
        });
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
