#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/flow/heat_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/lanes-inl.h"
#include "core/flow/heat_kernel.h"
#include "core/flow/row_sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::CappedTag<float, kAirLanes>;
using V = hn::Vec<D>;

/// The heat of quads.
HWY_INLINE V heatOf(D d, const AirColumn& quads, std::size_t at)
{
    V u, v, w, heat;
    hn::LoadInterleaved4(d, quads.data() + at, u, v, w, heat);
    return heat;
}

/// Calls visit(i, cell, quad, isAir) for whole vectors of a row: i in the row, its cell among the columns and its quad;
/// then rowDone().
template <class Visit, class RowDone>
HWY_INLINE void forRows(D d, const AirCells& cells, int k, const Visit& visit, const RowDone& rowDone)
{
    const auto n = static_cast<std::size_t>(cells.grid.cells.x);
    for (int j = 0; j < cells.grid.cells.y; ++j) {
        const std::size_t cell = cells.column.at(0, j, k);
        const std::size_t quad = cells.quad.at(0, j, k);
        for (std::size_t i = 0; i < n; i += hn::Lanes(d)) {
            auto isAir = hn::FirstN(d, n - i);
            if (cells.hasObstacles()) {
                isAir = hn::And(isAir, hn::Ne(hn::Load(d, cells.fluid.data() + cell + i), hn::Zero(d)));
            }
            visit(i, cell + i, quad + 4 * i, isAir);
        }
        rowDone(n);
    }
}

double sumOfAir(const AirCells& cells, int k)
{
    const D d;
    RowSums sum;
    const auto visit = [&](std::size_t i, std::size_t /*cell*/, std::size_t quad, auto isAir)
                           HWY_ATTR { sum.put(d, i, hn::IfThenElseZero(isAir, heatOf(d, cells.air, quad))); };
    forRows(d, cells, k, visit, [&](std::size_t n) HWY_ATTR { sum.add(n); });
    return sum.all();
}

CarriedHeat sumsOfCarried(const AirCells& cells, int k)
{
    const D d;
    RowSums all;
    RowSums more;
    RowSums less;
    const auto visit = [&](std::size_t i, std::size_t cell, std::size_t quad, auto isAir) HWY_ATTR {
        const V heat = hn::Load(d, cells.heat.data() + cell);
        const V guess = heatOf(d, cells.guess, quad);
        all.put(d, i, hn::IfThenElseZero(isAir, heat));
        more.put(d, i, hn::IfThenElseZero(isAir, hn::Max(hn::Zero(d), guess - heat)));
        less.put(d, i, hn::IfThenElseZero(isAir, hn::Max(hn::Zero(d), heat - guess)));
    };
    forRows(d, cells, k, visit, [&](std::size_t n) HWY_ATTR {
        all.add(n);
        more.add(n);
        less.add(n);
    });
    return {all.all(), more.all(), less.all()};
}

void correctPlane(AirCells& cells, float up, float down, int k)
{
    const D d;
    const V zero = hn::Zero(d);
    const auto visit = [&](std::size_t /*i*/, std::size_t cell, std::size_t quad, auto /*isAir*/) HWY_ATTR {
        const V heat = hn::Load(d, cells.heat.data() + cell);
        const V more = heatOf(d, cells.guess, quad) - heat;
        hn::Store(heat + (up * hn::Max(zero, more) + down * hn::Min(zero, more)), d, cells.heat.data() + cell);
    };
    forRows(d, cells, k, visit, [](std::size_t /*n*/) {});
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(sumOfAir);
HWY_EXPORT(sumsOfCarried);
HWY_EXPORT(correctPlane);

double heatOfAir(const AirCells& cells, int k)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(sumOfAir);
    return kernel(cells, k);
}

CarriedHeat carriedHeat(const AirCells& cells, int k)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(sumsOfCarried);
    return kernel(cells, k);
}

void correctHeat(AirCells& cells, float up, float down, int k)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(correctPlane);
    kernel(cells, up, down, k);
}

} // namespace fumage
#endif
