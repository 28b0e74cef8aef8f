#include "core/flow/solver.h"

#include "core/flow/advection_kernel.h"
#include "core/flow/boundaries.h"
#include "core/flow/force_kernel.h"
#include "core/flow/planes.h"
#include "core/flow/project_kernel.h"
#include "core/flow/shift.h"
#include "core/flow/source_kernel.h"

#include <algorithm>
#include <cassert>

namespace fumage {

namespace {

AirCells cellsWith(const AirGrid& grid, const AirBoundaries& boundaries, std::span<const Solid> solids)
{
    AirCells cells(grid, boundaries);
    [[maybe_unused]] const SolidsPlaced placed = placeSolids(cells, solids);
    assert(placed != SolidsPlaced::Nowhere);
    return cells;
}

/// Planes of a slab: enough that what is computed for both of two neighbours does not count, and few enough that all
/// threads have some.
constexpr int kSlab = 8;

/// Calls body(first, last) for slabs of planes [first, last).
template <class Body>
void forSlabs(const ColumnLayout& layout, const Body& body)
{
    const int planes = layout.cells.z;
    forPlanes(layout, 0, (planes + kSlab - 1) / kSlab, 1,
        [&](int slab) { body(slab * kSlab, std::min(planes, (slab + 1) * kSlab)); });
}

/// Makes the numbers of plane k 0, with their ghosts, and those of the plane of ghosts beyond it where it is the first
/// or the last.
void clearPlane(AirColumn& column, const ColumnLayout& layout, int k)
{
    const int first = k == 0 ? -1 : k;
    const int end = k + 1 == layout.cells.z ? k + 2 : k + 1;
    std::fill(column.begin() + layout.planeStart(first), column.begin() + layout.planeStart(end), 0.0F);
}

/// Fills the ghosts of the state beside plane k.
void fillGhosts(AirCells& cells, const glm::vec3& wind, int k)
{
    fillQuadGhosts(cells, cells.air, wind, k);
    fillQuadGhosts(cells, cells.carrier, wind, k);
}

void fillHalos(AirCells& cells)
{
    fillHalo(cells, cells.air);
    fillHalo(cells, cells.carrier);
}

} // namespace

CurlAround AirSolver::CurlPlanes::around(const AirCells& cells, int k, bool isFirst)
{
    const int last = cells.grid.cells.z - 1;
    const auto of = [&](int plane) -> CurlPlane& {
        return planes[static_cast<std::size_t>(std::clamp(plane, 0, last)) % planes.size()];
    };
    for (int plane = isFirst ? std::max(0, k - 1) : k + 1; plane <= std::min(k + 1, last); ++plane) {
        of(plane).makeRoom(cells.column);
        findCurl(cells, plane, of(plane));
    }
    return {&of(k - 1), &of(k), &of(k + 1)};
}

AirSolver::AirSolver(
    const AirGrid& grid, const AirBoundaries& boundaries, std::span<const Solid> solids, const glm::vec3& wind)
    : m_cells(cellsWith(grid, boundaries, solids))
    , m_solids(solids.begin(), solids.end())
    , m_multigrid(grid.cells, boundaries, m_cells.open)
    , m_heat(grid.cells.z)
    , m_confinement(grid.cells.z)
{
    if (wind != glm::vec3(0.0F)) {
        set([&](const glm::vec3&) { return glm::vec4(wind, 0.0F); }, wind);
    }
}

void AirSolver::step(const AirStep& step)
{
    for (const AirStep& part : step.earlier) {
        this->step(part);
    }
    moveObstacle(step);
    for (int piece = 0; piece < step.pieces; ++piece) {
        stepPiece(step);
    }
}

void AirSolver::step(const AirStep& step, AirField& field)
{
    field.earlier.resize(step.earlier.size());
    for (std::size_t i = 0; i < step.earlier.size(); ++i) {
        AirField& part = field.earlier[i];
        if (part.quads.size() != field.quads.size()) {
            part = AirField(grid());
        }
        this->step(step.earlier[i], part);
    }
    moveObstacle(step);
    for (int piece = 0; piece < step.pieces; ++piece) {
        stepPiece(step);
    }
    field.grid = grid();
    field.wind = step.wind;
    field.share = step.share;
    field.obstacle = step.obstacle;
    read(field);
}

bool AirSolver::place(std::span<const Solid> solids)
{
    const SolidsPlaced placed = placeSolids(m_cells, solids);
    if (placed == SolidsPlaced::Elsewhere) {
        m_multigrid.setFaces(m_cells.open, m_cells.changed);
    }
    if (placed != SolidsPlaced::Nowhere) {
        m_solids.assign(solids.begin(), solids.end());
    }
    return placed != SolidsPlaced::Nowhere;
}

void AirSolver::moveObstacle(const AirStep& step)
{
    if (!step.obstacle) {
        return;
    }
    const std::span<const Solid> now(&*step.obstacle, 1);
    if (!std::equal(now.begin(), now.end(), m_solids.begin(), m_solids.end()) && place(now)) {
        fillHalos(m_cells);
    }
}

void AirSolver::stepPiece(const AirStep& step)
{
    AirCells& cells = m_cells;
    const int planes = cells.grid.cells.z;
    const bool confines = step.confinement > 0.0F;
    const glm::vec3 wind = step.wind - step.windChange;
    const bool keepsHeat = !step.acts(); // beside a source the sum is what the source makes it
    forPlanes(cells.column, 0, planes, 1, [&](int k) {
        if (keepsHeat) {
            m_heat.before(cells, step.dt, k);
        }
        if (confines) {
            m_confinement.plane(k).before = motionOfAir(cells, wind, k);
        }
        traceBack(cells, step.dt, k);
        fillQuadGhosts(cells, cells.guess, step.wind, k);
    });
    fillHalo(cells, cells.guess);
    forPlanes(cells.column, 0, planes, 1, [&](int k) {
        correctTrace(cells, step.dt, k);
        if (keepsHeat) {
            m_heat.after(cells, k);
        }
        clearPlane(cells.divergence, cells.column, k);
        if (confines) {
            m_confinement.plane(k).carried = motionOfCarried(cells, wind, k);
        }
        addSource(cells, step.source, k);
        for (const AirFeed& feed : step.others) {
            addSource(cells, feed.source, k);
        }
        if (confines) {
            fillVelocityGhosts(cells, cells.velocity, k);
        }
    });
    const HeatBudget::Correction correction = keepsHeat ? m_heat.correction() : HeatBudget::Correction();
    forSlabs(cells.column, [&](int first, int last) {
        CurlPlanes& curl = m_curl.local();
        for (int k = first; k < last; ++k) {
            if (keepsHeat) {
                HeatBudget::correct(cells, correction, k);
            }
            addForces(cells, step, k, confines ? curl.around(cells, k, k == first) : CurlAround{},
                m_confinement.plane(k).work);
            slowInflow(cells, step.wind, step.dt, k);
            fillVelocityGhosts(cells, cells.forced, k);
        }
    });
    if (confines) {
        limitConfinement(step);
    }
    project(step.wind);
}

void AirSolver::limitConfinement(const AirStep& step)
{
    AirCells& cells = m_cells;
    const float share = m_confinement.share();
    if (share == 1.0F) {
        return;
    }
    forSlabs(cells.column, [&](int first, int last) {
        CurlPlanes& curl = m_curl.local();
        for (int k = first; k < last; ++k) {
            weakenConfinement(cells, step, 1.0F - share, k, curl.around(cells, k, k == first));
            fillVelocityGhosts(cells, cells.forced, k);
        }
    });
}

void AirSolver::project(const glm::vec3& wind)
{
    AirCells& cells = m_cells;
    const int planes = cells.grid.cells.z;
    forPlanes(cells.column, 0, planes, 1, [&](int k) {
        findDivergence(cells, k);
        clearPlane(cells.pressure, cells.column, k);
    });
    if (cells.boundaries.closed()) {
        balance();
    }
    m_multigrid.solve(cells.pressure, cells.divergence, kCycles);
    forPlanes(cells.column, 0, planes, 1, [&](int k) {
        fillPressureGhosts(cells, cells.pressure, k);
        fillEvenGhosts(cells, cells.heat, k);
    });
    forPlanes(cells.column, 0, planes, 1, [&](int k) {
        subtractGradient(cells, k);
        fillGhosts(cells, wind, k);
    });
    fillHalos(cells);
}

bool AirSolver::move(const glm::ivec3& by, const glm::vec3& corner, const AirBoundaries& boundaries,
    std::span<const Solid> solids, const glm::vec3& wind)
{
    AirCells& cells = m_cells;
    const glm::vec3 before = cells.grid.corner;
    const bool hadObstacles = cells.hasObstacles();
    cells.grid.corner = corner;
    if (!solids.empty() && placeSolids(cells, solids) == SolidsPlaced::Nowhere) {
        cells.grid.corner = before;
        return false;
    }
    m_solids.assign(solids.begin(), solids.end());
    if (hadObstacles || cells.hasObstacles() || boundaries != cells.boundaries) {
        m_multigrid = Multigrid(cells.grid.cells, boundaries, cells.open);
    }
    cells.boundaries = boundaries;
    for (AirColumn* quads : {&cells.air, &cells.carrier}) {
        std::swap(*quads, cells.guess);
        forPlanes(cells.column, 0, cells.grid.cells.z, 1,
            [&](int k) { shiftPlane(cells, cells.guess, by, wind, *quads, k); });
    }
    forPlanes(cells.column, 0, cells.grid.cells.z, 1, [&](int k) { fillGhosts(cells, wind, k); });
    fillHalos(cells);
    return true;
}

void AirSolver::balance()
{
    double sum = 0.0;
    double count = 0.0;
    const auto forAir = [&](const auto& visit) {
        forCells(m_cells.grid.cells, [&](const glm::ivec3& c) {
            if (!isSolid(c)) {
                visit(m_cells.divergence[m_cells.column.at(c.x, c.y, c.z)]);
            }
        });
    };
    forAir([&](float each) {
        sum += static_cast<double>(each);
        count += 1.0;
    });
    const auto mean = static_cast<float>(sum / count);
    forAir([&](float& each) { each -= mean; });
}

void AirSolver::set(const std::function<glm::vec4(const glm::vec3& place)>& airAt, const glm::vec3& wind)
{
    AirCells& cells = m_cells;
    const glm::ivec3 n = cells.grid.cells;
    forCells(n, [&](const glm::ivec3& c) {
        const std::size_t at = cells.column.at(c.x, c.y, c.z);
        const glm::vec4 air = isSolid(c) ? glm::vec4(0.0F) : airAt(cells.grid.centre(c));
        cells.forced.x[at] = air.x;
        cells.forced.y[at] = air.y;
        cells.forced.z[at] = air.z;
        cells.heat[at] = air.w;
    });
    for (int k = 0; k < n.z; ++k) {
        fillVelocityGhosts(cells, cells.forced, k);
    }
    std::fill(cells.divergence.begin(), cells.divergence.end(), 0.0F);
    project(wind);
}

void AirSolver::restore(const AirState& state)
{
    m_cells.air = state.air;
    m_cells.carrier = state.carrier;
    if (state.solids != m_solids) {
        place(state.solids);
    }
}

void AirSolver::read(AirField& field) const
{
    forPlanes(m_cells.column, 0, m_cells.grid.cells.z + 1, 1, [&](int k) { writeNodes(m_cells, field, k); });
}

bool AirSolver::isSolid(const glm::ivec3& cell) const
{
    return m_cells.hasObstacles() && m_cells.fluid[m_cells.column.at(cell.x, cell.y, cell.z)] == 0.0F;
}

glm::vec4 AirSolver::at(const glm::ivec3& cell) const
{
    const float* quad = m_cells.air.data() + m_cells.quad.at(cell.x, cell.y, cell.z);
    return {quad[0], quad[1], quad[2], quad[3]};
}

float AirSolver::divergenceAt(const glm::ivec3& cell) const
{
    const std::size_t at = m_cells.column.at(cell.x, cell.y, cell.z);
    const auto outOf = [&](AirColumn AirVectors::*axis, std::size_t stride) {
        const AirColumn& velocity = m_cells.forced.*axis;
        const AirColumn& open = m_cells.open.*axis;
        const AirColumn& wall = m_cells.wall.*axis;
        const auto through = [&](std::size_t face) {
            const float mean = 0.5F * (velocity[face] + velocity[face - stride])
                - (m_cells.pressure[face] - m_cells.pressure[face - stride]);
            return (open.empty() ? mean : mean * open[face]) + (wall.empty() ? 0.0F : wall[face]);
        };
        return through(at + stride) - through(at);
    };
    return (outOf(&AirVectors::x, 1) + outOf(&AirVectors::y, m_cells.column.row)
               + outOf(&AirVectors::z, m_cells.column.plane))
        / m_cells.grid.cell;
}

} // namespace fumage
