#include "core/flow/multigrid.h"

#include "core/flow/multigrid_kernel.h"
#include "core/flow/planes.h"

#include <algorithm>
#include <array>

#include <glm/common.hpp>

namespace fumage {

namespace {

/// A level may be coarsened while its shortest side has as many cells.
constexpr int kMinToHalve = 4;

/// Before and after a coarser level.
constexpr int kSweeps = 2;

/// On the coarsest level, which may still be long: enough for a side of 16 cells.
constexpr int kSweepsOfLast = 40;

constexpr int halved(int cells)
{
    return (cells + 1) / 2;
}

MultigridAxis makeAxis(std::vector<float> width, Boundary low, Boundary high)
{
    MultigridAxis axis;
    axis.width = std::move(width);
    const std::size_t n = axis.width.size();
    axis.cells = static_cast<int>(n);
    const std::size_t room = n + 2 * kAirLanes;
    for (AirColumn* column : {&axis.below, &axis.above, &axis.own, &axis.share, &axis.within, &axis.beside}) {
        column->assign(room, 0.0F);
    }
    for (std::size_t i = 0; i < n; ++i) {
        const float w = axis.width[i];
        axis.below[i] = i > 0 ? 2.0F / (w * (w + axis.width[i - 1])) : 0.0F;
        axis.above[i] = i + 1 < n ? 2.0F / (w * (w + axis.width[i + 1])) : 0.0F;
        const bool openBelow = i == 0 && low == Boundary::Open;
        const bool openAbove = i + 1 == n && high == Boundary::Open;
        axis.own[i] =
            axis.below[i] + axis.above[i] + (openBelow ? 2.0F / (w * w) : 0.0F) + (openAbove ? 2.0F / (w * w) : 0.0F);
    }
    return axis;
}

/// How the cells of an axis lie in the coarser ones: two in each, and one in the last where their number is odd.
void linkAxis(MultigridAxis& fine, const MultigridAxis& coarse, Boundary low, Boundary high)
{
    for (std::size_t i = 0; i < fine.width.size(); ++i) {
        const std::size_t parent = i / 2;
        const float w = fine.width[i];
        const float all = coarse.width[parent];
        fine.share[i] = w / all;
        const float offset = 0.5F * (all - w); // between the centres of the cell and its coarse one
        const bool isLower = i % 2 == 0;
        const bool atBorder = isLower ? parent == 0 : parent + 1 == coarse.width.size();
        if (offset == 0.0F) {
            fine.within[i] = 1.0F;
        } else if (atBorder) {
            const bool isOpen = (isLower ? low : high) == Boundary::Open;
            fine.within[i] = isOpen ? 1.0F - offset / (0.5F * all) : 1.0F;
        } else {
            const float neighbour = coarse.width[isLower ? parent - 1 : parent + 1];
            fine.beside[i] = offset / (0.5F * (all + neighbour));
            fine.within[i] = 1.0F - fine.beside[i];
        }
    }
}

std::vector<float> coarserWidths(const std::vector<float>& width)
{
    std::vector<float> out;
    for (std::size_t i = 0; i < width.size(); i += 2) {
        out.push_back(i + 1 < width.size() ? width[i] + width[i + 1] : width[i]);
    }
    return out;
}

/// The same as forCellsOf(), several planes at once.
template <class Visit>
void forCellsByPlane(const CellBox& box, const Visit& visit)
{
    forPlanes(box, [&](int k) { forCellsOf({{box.low.x, box.low.y, k}, {box.high.x, box.high.y, k + 1}}, visit); });
}

/// The cells of the coarser level that have cells of a box in them.
CellBox coarsened(const CellBox& box)
{
    return {box.low / 2, (box.high + 1) / 2};
}

/// Takes the lower faces of the cells of a box, and those above it.
void copyFaces(const ColumnLayout& layout, const CellBox& box, const AirColumn& from, AirColumn& to)
{
    forRows(layout, {box.low, box.high + 1},
        [&](std::size_t at, int count) { std::copy_n(from.data() + at, count, to.data() + at); });
}

/// The share of a coarse face that lets air through is the mean of the fine faces in it.
/// @param box cells of the coarse level whose faces these are; those of the border above too
void coarsenFaces(
    const MultigridLevel& fine, MultigridLevel& coarse, AirColumn AirVectors::*faces, int axis, const CellBox& box)
{
    const glm::ivec3 n = fine.layout.cells;
    CellBox lower = box;
    ++lower.high[axis];
    forCellsByPlane(lower, [&](const glm::ivec3& c) {
        glm::ivec3 low = 2 * c;
        low[axis] = std::min(low[axis], n[axis]);
        glm::ivec3 high = glm::min(low + 2, n);
        high[axis] = low[axis] + 1;
        float sum = 0.0F;
        float count = 0.0F;
        forCellsOf({low, high}, [&](const glm::ivec3& at) {
            sum += (fine.open.*faces)[fine.layout.at(at.x, at.y, at.z)];
            count += 1.0F;
        });
        (coarse.open.*faces)[coarse.layout.at(c.x, c.y, c.z)] = sum / count;
    });
}

/// 1 / the weight of -p in every cell of a box; 0 where no face is open.
void invertWeights(MultigridLevel& level, const CellBox& box)
{
    const auto borderOf = [](const MultigridAxis& axis, std::size_t i) {
        return axis.own[i] - axis.below[i] - axis.above[i];
    };
    const auto weightOf = [&](const MultigridAxis& axis, std::size_t i, float lower, float upper) {
        return axis.below[i] * lower + axis.above[i] * upper + borderOf(axis, i) * (i == 0 ? lower : upper);
    };
    forPlanes(box, [&](int k) {
        for (int j = box.low.y; j < box.high.y; ++j) {
            const std::size_t first = level.layout.at(0, j, k);
            const float* x = level.open.x.data() + first;
            const float* y = level.open.y.data() + first;
            const float* z = level.open.z.data() + first;
            float* inverse = level.inverse.data() + first;
            const auto end = static_cast<std::size_t>(box.high.x);
            for (auto i = static_cast<std::size_t>(box.low.x); i < end; ++i) {
                float sum = weightOf(level.axis[0], i, x[i], x[i + 1]);
                sum += weightOf(level.axis[1], static_cast<std::size_t>(j), y[i], y[i + level.layout.row]);
                sum += weightOf(level.axis[2], static_cast<std::size_t>(k), z[i], z[i + level.layout.plane]);
                constexpr float kShut = 1e-4F;
                inverse[i] = sum > kShut ? 1.0F / sum : 0.0F;
            }
        }
    });
}

void sweep(const MultigridLevel& level, AirColumn& pressure, const AirColumn& rightSide, int times)
{
    for (int time = 0; time < times; ++time) {
        for (int first = 0; first < 2; ++first) {
            forPlanes(
                level.layout, first, level.layout.cells.z, 2, [&](int k) { relax(level, pressure, rightSide, k); });
        }
    }
}

} // namespace

Multigrid::Multigrid(const glm::ivec3& cells, const AirBoundaries& boundaries, const AirVectors& open)
{
    std::array<std::vector<float>, 3> widths;
    for (int a = 0; a < 3; ++a) {
        widths[static_cast<std::size_t>(a)].assign(static_cast<std::size_t>(cells[a]), 1.0F);
    }
    glm::ivec3 n = cells;
    while (true) {
        MultigridLevel& level = m_levels.emplace_back(n);
        for (std::size_t a = 0; a < 3; ++a) {
            level.axis[a] = makeAxis(widths[a], boundaries.low[a], boundaries.high[a]);
            widths[a] = coarserWidths(widths[a]);
        }
        if (std::min({n.x, n.y, n.z}) < kMinToHalve) {
            break;
        }
        n = {halved(n.x), halved(n.y), halved(n.z)};
    }
    for (std::size_t l = 0; l < m_levels.size(); ++l) {
        MultigridLevel& level = m_levels[l];
        if (l > 0) {
            level.pressure.assign(level.layout.size, 0.0F);
            level.rightSide.assign(level.layout.size, 0.0F);
            for (std::size_t a = 0; a < 3; ++a) {
                linkAxis(m_levels[l - 1].axis[a], level.axis[a], boundaries.low[a], boundaries.high[a]);
            }
        }
    }
    setFaces(open, {glm::ivec3(0), cells});
}

void Multigrid::setFaces(const AirVectors& open, const CellBox& changed)
{
    if (open.x.empty()) {
        for (MultigridLevel& level : m_levels) {
            level.open.clear();
            level.inverse.clear();
        }
        return;
    }
    CellBox box = changed;
    for (std::size_t l = 0; l < m_levels.size(); ++l) {
        MultigridLevel& level = m_levels[l];
        const glm::ivec3 n = level.layout.cells;
        if (level.open.x.empty()) {
            level.open.resize(level.layout.size);
            level.inverse.assign(level.layout.size, 0.0F);
            box = {glm::ivec3(0), n};
        }
        const std::array faces{&AirVectors::x, &AirVectors::y, &AirVectors::z};
        for (int axis = 0; axis < 3; ++axis) {
            AirColumn AirVectors::*of = faces[static_cast<std::size_t>(axis)];
            if (l == 0) {
                copyFaces(level.layout, box, open.*of, level.open.*of);
            } else {
                coarsenFaces(m_levels[l - 1], level, of, axis, box);
            }
        }
        // A face is of the cell before it, too.
        invertWeights(level, {glm::max(box.low - 1, glm::ivec3(0)), glm::min(box.high + 1, n)});
        box = coarsened(box);
    }
}

void Multigrid::cycle(std::size_t level, AirColumn& pressure, AirColumn& rightSide)
{
    const MultigridLevel& fine = m_levels[level];
    if (level + 1 == m_levels.size()) {
        sweep(fine, pressure, rightSide, kSweepsOfLast);
        return;
    }
    MultigridLevel& coarse = m_levels[level + 1];
    sweep(fine, pressure, rightSide, kSweeps);
    forPlanes(fine.layout, 0, coarse.layout.cells.z, 1,
        [&](int k) { restrictResidual(fine, pressure, rightSide, coarse, k); });
    cycle(level + 1, coarse.pressure, coarse.rightSide);
    forPlanes(fine.layout, 0, fine.layout.cells.z, 1, [&](int k) { prolong(fine, coarse, pressure, k); });
    sweep(fine, pressure, rightSide, kSweeps);
}

void Multigrid::solve(AirColumn& pressure, AirColumn& rightSide, int cycles)
{
    for (int i = 0; i < cycles; ++i) {
        cycle(0, pressure, rightSide);
    }
}

} // namespace fumage
