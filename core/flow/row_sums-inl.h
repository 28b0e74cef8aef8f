// Included once per SIMD target: sums over the cells of a plane, the same on every instruction set.

#if defined(FUMAGE_ROW_SUMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMAGE_ROW_SUMS_INL_H
#undef FUMAGE_ROW_SUMS_INL_H
#else
#define FUMAGE_ROW_SUMS_INL_H
#endif

#include "core/base/lanes-inl.h"
#include "core/flow/grid.h"

#include <numeric>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// Numbers of a row of cells, summed up: number i goes into sum i % kAirLanes.
class RowSums {
public:
    /// Number i of the row and those after it; those of no air are 0.
    template <class D>
    HWY_INLINE void put(D d, std::size_t i, hn::VFromD<D> numbers)
    {
        hn::Store(numbers, d, m_row + i);
    }

    /// Adds the first n of the row, rounded up to whole vectors.
    HWY_INLINE void add(std::size_t n)
    {
        const hn::CappedTag<double, kAirLanes / 2> d;
        const hn::Rebind<float, decltype(d)> numbers;
        for (std::size_t i = 0; i < n; i += hn::Lanes(d)) {
            double* sum = m_sums + i % kAirLanes;
            hn::Store(hn::Add(hn::Load(d, sum), hn::PromoteTo(d, hn::Load(numbers, m_row + i))), d, sum);
        }
    }

    [[nodiscard]] double all() const { return std::accumulate(std::begin(m_sums), std::end(m_sums), 0.0); }

private:
    HWY_ALIGN float m_row[kMaxAirCells + kAirLanes];
    HWY_ALIGN double m_sums[kAirLanes] = {};
};

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
