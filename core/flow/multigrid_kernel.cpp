#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/flow/multigrid_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/lanes-inl.h"
#include "core/flow/multigrid_kernel.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::CappedTag<float, kAirLanes>;
using V = hn::Vec<D>;

constexpr std::size_t kRowRoom = kMaxAirCells + 2 * kAirLanes;

/// The weights of a row of cells along y and z, and the way to the neighbours.
struct RowWeights {
    RowWeights(const MultigridLevel& level, int j, int k)
        : row(level.layout.row)
        , plane(level.layout.plane)
        , below(level.axis[1].below[static_cast<std::size_t>(j)])
        , above(level.axis[1].above[static_cast<std::size_t>(j)])
        , before(level.axis[2].below[static_cast<std::size_t>(k)])
        , behind(level.axis[2].above[static_cast<std::size_t>(k)])
        , own(level.axis[1].own[static_cast<std::size_t>(j)] + level.axis[2].own[static_cast<std::size_t>(k)])
    {
    }

    std::size_t row, plane;
    float below, above, before, behind, own;
};

/// The weighted sum of a cell's neighbours.
template <bool kObstacles>
HWY_INLINE V neighbours(D d, const MultigridLevel& level, const RowWeights& weights, const float* HWY_RESTRICT p,
    std::size_t at, std::size_t i)
{
    const auto way = [&](V weight, std::ptrdiff_t stride, const AirColumn& faces) HWY_ATTR {
        const V other = hn::LoadU(d, p + static_cast<std::ptrdiff_t>(at) + stride);
        if constexpr (kObstacles) {
            return weight
                * hn::LoadU(d, faces.data() + static_cast<std::ptrdiff_t>(at) + std::max<std::ptrdiff_t>(stride, 0))
                * other;
        }
        return weight * other;
    };
    const auto row = static_cast<std::ptrdiff_t>(weights.row);
    const auto plane = static_cast<std::ptrdiff_t>(weights.plane);
    const V x = way(hn::Load(d, level.axis[0].below.data() + i), -1, level.open.x)
        + way(hn::Load(d, level.axis[0].above.data() + i), 1, level.open.x);
    const V y = way(hn::Set(d, weights.below), -row, level.open.y) + way(hn::Set(d, weights.above), row, level.open.y);
    const V z =
        way(hn::Set(d, weights.before), -plane, level.open.z) + way(hn::Set(d, weights.behind), plane, level.open.z);
    return x + y + z;
}

/// 1 / the weight of -p for the cells of a row; 0 in its padding, so that the padding of pressures stays 0.
HWY_INLINE void invertRow(D d, const MultigridLevel& level, float own, float* HWY_RESTRICT inverse)
{
    const auto n = static_cast<std::size_t>(level.axis[0].cells);
    for (std::size_t i = 0; i < n; i += hn::Lanes(d)) {
        const V all = hn::Load(d, level.axis[0].own.data() + i) + own;
        hn::Store(hn::IfThenElseZero(hn::FirstN(d, n - i), 1.0F / all), d, inverse + i);
    }
}

/// Which of a row's cells are the second of two.
HWY_ALIGN constexpr float kOdd[2 + kAirLanes] = {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1};

/// How many rows black cells are behind white ones: by then those have reached the cache, and what is loaded across two
/// of their vectors need not wait.
constexpr int kRowsBehind = 4;

/// Relaxes every other cell of a row.
/// @param lane 0 for the first and those with it, 1 for the others
template <bool kObstacles>
HWY_INLINE void relaxRow(D d, const MultigridLevel& level, const RowWeights& weights, std::size_t lane,
    std::size_t start, float* HWY_RESTRICT p, const float* HWY_RESTRICT rightSide, const float* HWY_RESTRICT inverse)
{
    const auto n = static_cast<std::size_t>(level.layout.cells.x);
    const auto relaxed = [&](std::size_t i) HWY_ATTR {
        const auto isMine = hn::Eq(hn::LoadU(d, kOdd + (i + lane) % 2), hn::Zero(d));
        const std::size_t at = start + i;
        const V sum = neighbours<kObstacles>(d, level, weights, p, at, i) - hn::Load(d, rightSide + at);
        return hn::IfThenElse(isMine, sum * hn::Load(d, inverse + i), hn::Load(d, p + at));
    };
    // A vector is stored after the next one has been loaded across its end, which would else wait for it to reach the
    // cache. The other half of the cells, which is all that is read across, stays as it is.
    V before = relaxed(0);
    std::size_t i = hn::Lanes(d);
    for (; i < n; i += hn::Lanes(d)) {
        const V here = relaxed(i);
        hn::Store(before, d, p + start + i - hn::Lanes(d));
        before = here;
    }
    hn::Store(before, d, p + start + i - hn::Lanes(d));
}

/// A plane's white cells and, some rows behind them, its black ones.
template <bool kObstacles>
HWY_INLINE void relaxWith(
    const MultigridLevel& level, float* HWY_RESTRICT p, const float* HWY_RESTRICT rightSide, int k)
{
    const D d;
    HWY_ALIGN float inverses[2]
                            [kRowRoom]; // of a colour each: they are rows apart, whose weights differ beside a border
    float invertedFor[2] = {-1.0F, -1.0F};
    const int rows = level.layout.cells.y;
    for (int turn = 0; turn < 2 * (rows + kRowsBehind); ++turn) {
        const int colour = turn % 2;
        const int j = turn / 2 - colour * kRowsBehind;
        if (j < 0 || j >= rows) {
            continue;
        }
        const RowWeights weights(level, j, k);
        const std::size_t start = level.layout.at(0, j, k);
        float* rowInverse = inverses[colour];
        if (!kObstacles && invertedFor[colour] != weights.own) {
            invertRow(d, level, weights.own, rowInverse);
            invertedFor[colour] = weights.own;
        }
        const float* inverse = kObstacles ? level.inverse.data() + start : rowInverse;
        relaxRow<kObstacles>(
            d, level, weights, static_cast<std::size_t>((j + k + colour) % 2), start, p, rightSide, inverse);
    }
}

void relaxPlane(const MultigridLevel& level, AirColumn& pressure, const AirColumn& rightSide, int k)
{
    const auto relax = level.inverse.empty() ? &relaxWith<false> : &relaxWith<true>;
    relax(level, pressure.data(), rightSide.data(), k);
}

/// Adds the weighted residual of a row of fine cells.
template <bool kObstacles>
HWY_INLINE void addResidual(const MultigridLevel& level, const float* HWY_RESTRICT p,
    const float* HWY_RESTRICT rightSide, int j, int k, float share, float* HWY_RESTRICT sum)
{
    const D d;
    const RowWeights weights(level, j, k);
    const std::size_t start = level.layout.at(0, j, k);
    for (std::size_t i = 0; i < static_cast<std::size_t>(level.layout.cells.x); i += hn::Lanes(d)) {
        const std::size_t at = start + i;
        const V pressure = hn::Load(d, p + at);
        const V around = neighbours<kObstacles>(d, level, weights, p, at, i);
        V residual;
        if constexpr (kObstacles) {
            // A weight of 0 stands for a cell of an obstacle, which has no residual.
            const V inverse = hn::Load(d, level.inverse.data() + at);
            const auto isAir = hn::Gt(inverse, hn::Zero(d));
            residual = hn::IfThenElseZero(isAir,
                hn::Load(d, rightSide + at) - around
                    + pressure * (1.0F / hn::IfThenElse(isAir, inverse, hn::Set(d, 1.0F))));
        } else {
            residual = hn::Load(d, rightSide + at) - around
                + pressure * (hn::Load(d, level.axis[0].own.data() + i) + weights.own);
        }
        const V weight = hn::Load(d, level.axis[0].share.data() + i) * share;
        hn::Store(hn::Load(d, sum + i) + weight * residual, d, sum + i);
    }
}

void restrictPlane(
    const MultigridLevel& fine, const AirColumn& pressure, const AirColumn& rightSide, MultigridLevel& coarse, int k)
{
    const D d;
    HWY_ALIGN float sum[kRowRoom];
    const glm::ivec3 n = fine.layout.cells;
    for (int j = 0; j < coarse.layout.cells.y; ++j) {
        std::fill(std::begin(sum), std::end(sum), 0.0F);
        for (int z = 2 * k; z < std::min(2 * k + 2, n.z); ++z) {
            for (int y = 2 * j; y < std::min(2 * j + 2, n.y); ++y) {
                const float share =
                    fine.axis[1].share[static_cast<std::size_t>(y)] * fine.axis[2].share[static_cast<std::size_t>(z)];
                const auto add = fine.inverse.empty() ? &addResidual<false> : &addResidual<true>;
                add(fine, pressure.data(), rightSide.data(), y, z, share, sum);
            }
        }
        const std::size_t start = coarse.layout.at(0, j, k);
        for (std::size_t i = 0; i < static_cast<std::size_t>(coarse.layout.cells.x); i += hn::Lanes(d)) {
            V even;
            V odd;
            hn::LoadInterleaved2(d, sum + 2 * i, even, odd);
            hn::Store(even + odd, d, coarse.rightSide.data() + start + i);
            hn::Store(hn::Zero(d), d, coarse.pressure.data() + start + i);
        }
    }
}

/// The coarse cell that a fine one lies in, and the one beside it on the fine one's side; its own where there is none,
/// with a weight of 0.
struct CoarseCells {
    CoarseCells(const MultigridAxis& fine, int index, int cells)
        : within(fine.within[static_cast<std::size_t>(index)])
        , beside(fine.beside[static_cast<std::size_t>(index)])
        , own(index / 2)
        , other(std::clamp(index % 2 == 0 ? own - 1 : own + 1, 0, cells - 1))
    {
    }

    float within, beside;
    int own, other;
};

/// A row of coarse pressures between those around row j of plane k of the fine cells.
HWY_INLINE void mixRow(
    const MultigridLevel& fine, const MultigridLevel& coarse, const CoarseCells& z, int j, float* HWY_RESTRICT row)
{
    const D d;
    const CoarseCells y(fine.axis[1], j, coarse.layout.cells.y);
    const auto from = [&](int own, int other, std::size_t i) HWY_ATTR {
        return hn::Load(d, coarse.pressure.data() + coarse.layout.at(0, own, other) + i);
    };
    for (std::size_t i = 0; i < static_cast<std::size_t>(coarse.layout.cells.x); i += hn::Lanes(d)) {
        const V within = z.within * from(y.own, z.own, i) + z.beside * from(y.own, z.other, i);
        const V beside = z.within * from(y.other, z.own, i) + z.beside * from(y.other, z.other, i);
        hn::Store(y.within * within + y.beside * beside, d, row + i);
    }
}

/// Adds such a row, interpolated along x, to a row of fine pressures.
HWY_INLINE void addRow(
    const MultigridLevel& fine, const MultigridLevel& coarse, const float* HWY_RESTRICT row, float* HWY_RESTRICT p)
{
    const D d;
    const float* HWY_RESTRICT within = fine.axis[0].within.data();
    const float* HWY_RESTRICT beside = fine.axis[0].beside.data();
    // Two fine cells a coarse one; a last vector of them may reach beyond the row, so it goes through memory of its
    // own.
    HWY_ALIGN float fineRow[2 * kRowRoom];
    for (std::size_t i = 0; i < static_cast<std::size_t>(coarse.layout.cells.x); i += hn::Lanes(d)) {
        V withinEven, withinOdd, besideEven, besideOdd;
        hn::LoadInterleaved2(d, within + 2 * i, withinEven, withinOdd);
        hn::LoadInterleaved2(d, beside + 2 * i, besideEven, besideOdd);
        const V own = hn::Load(d, row + i);
        const V even = withinEven * own + besideEven * hn::LoadU(d, row + i - 1);
        const V odd = withinOdd * own + besideOdd * hn::LoadU(d, row + i + 1);
        hn::StoreInterleaved2(even, odd, d, fineRow + 2 * i);
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(fine.layout.cells.x); i += hn::Lanes(d)) {
        hn::Store(hn::Load(d, p + i) + hn::Load(d, fineRow + i), d, p + i);
    }
}

void prolongPlane(const MultigridLevel& fine, const MultigridLevel& coarse, AirColumn& pressure, int k)
{
    // With room for the neighbour before a row. A row is mixed while the one before it is added: what is loaded across
    // two vectors waits until those are in the cache.
    HWY_ALIGN float between[2][kAirLanes + kRowRoom] = {};
    const CoarseCells z(fine.axis[2], k, coarse.layout.cells.z);
    const int rows = fine.layout.cells.y;
    for (int j = 0; j <= rows; ++j) {
        if (j < rows) {
            mixRow(fine, coarse, z, j, between[j % 2] + kAirLanes);
        }
        if (j > 0) {
            addRow(fine, coarse, between[(j - 1) % 2] + kAirLanes, pressure.data() + fine.layout.at(0, j - 1, k));
        }
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(relaxPlane);
HWY_EXPORT(restrictPlane);
HWY_EXPORT(prolongPlane);

void relax(const MultigridLevel& level, AirColumn& pressure, const AirColumn& rightSide, int k)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(relaxPlane);
    kernel(level, pressure, rightSide, k);
}

void restrictResidual(
    const MultigridLevel& fine, const AirColumn& pressure, const AirColumn& rightSide, MultigridLevel& coarse, int k)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(restrictPlane);
    kernel(fine, pressure, rightSide, coarse, k);
}

void prolong(const MultigridLevel& fine, const MultigridLevel& coarse, AirColumn& pressure, int k)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(prolongPlane);
    kernel(fine, coarse, pressure, k);
}

} // namespace fumage
#endif
