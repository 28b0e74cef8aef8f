#include "tests/benchmarks/obvious_air.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fumage::benchmarks {

ObviousAir::ObviousAir(int nx, int ny, int nz, float cell)
    : m_nx(nx)
    , m_ny(ny)
    , m_nz(nz)
    , m_cell(cell)
    , m_air(static_cast<std::size_t>(nx * ny * nz))
    , m_guess(m_air)
    , m_next(m_air)
    , m_pressure(m_air.size())
    , m_divergence(m_air.size())
{
}

std::size_t ObviousAir::at(int i, int j, int k) const
{
    return static_cast<std::size_t>(
        std::clamp(i, 0, m_nx - 1) + m_nx * (std::clamp(j, 0, m_ny - 1) + m_ny * std::clamp(k, 0, m_nz - 1)));
}

template <class Visit>
void ObviousAir::forCells(const Visit& visit) const
{
    for (int k = 0; k < m_nz; ++k) {
        for (int j = 0; j < m_ny; ++j) {
            for (int i = 0; i < m_nx; ++i) {
                visit(i, j, k);
            }
        }
    }
}

void ObviousAir::heat()
{
    forCells([&](int i, int j, int k) {
        const float r = std::hypot(
            static_cast<float>(i - m_nx / 2), static_cast<float>(j - m_ny / 5), static_cast<float>(k - m_nz / 2));
        m_air[at(i, j, k)].heat = r < static_cast<float>(m_nx) / 6.0F ? 1.0F : 0.0F;
    });
}

ObviousAir::Cell ObviousAir::sample(
    const std::vector<Cell>& from, float x, float y, float z, Cell* least, Cell* most) const
{
    const int i = static_cast<int>(std::floor(x));
    const int j = static_cast<int>(std::floor(y));
    const int k = static_cast<int>(std::floor(z));
    Cell sum;
    for (int corner = 0; corner < 8; ++corner) {
        const int a = corner & 1;
        const int b = corner >> 1 & 1;
        const int c = corner >> 2;
        const Cell& cell = from[at(i + a, j + b, k + c)];
        const float fx = x - static_cast<float>(i);
        const float fy = y - static_cast<float>(j);
        const float fz = z - static_cast<float>(k);
        const float weight = (a != 0 ? fx : 1.0F - fx) * (b != 0 ? fy : 1.0F - fy) * (c != 0 ? fz : 1.0F - fz);
        sum = {
            sum.u + weight * cell.u, sum.v + weight * cell.v, sum.w + weight * cell.w, sum.heat + weight * cell.heat};
        if (least != nullptr) {
            *least = corner == 0 ? cell
                                 : Cell{std::min(least->u, cell.u), std::min(least->v, cell.v),
                                     std::min(least->w, cell.w), std::min(least->heat, cell.heat)};
            *most = corner == 0 ? cell
                                : Cell{std::max(most->u, cell.u), std::max(most->v, cell.v), std::max(most->w, cell.w),
                                    std::max(most->heat, cell.heat)};
        }
    }
    return sum;
}

void ObviousAir::advect(float dt)
{
    const float scale = dt / m_cell;
    const auto way = [&](int i, int j, int k) {
        const Cell& here = m_air[at(i, j, k)];
        const float half = 0.5F * scale;
        return sample(m_air, static_cast<float>(i) - half * here.u, static_cast<float>(j) - half * here.v,
            static_cast<float>(k) - half * here.w, nullptr, nullptr);
    };
    forCells([&](int i, int j, int k) {
        const Cell d = way(i, j, k);
        m_guess[at(i, j, k)] = sample(m_air, static_cast<float>(i) - scale * d.u, static_cast<float>(j) - scale * d.v,
            static_cast<float>(k) - scale * d.w, nullptr, nullptr);
    });
    forCells([&](int i, int j, int k) {
        const Cell d = way(i, j, k);
        Cell least;
        Cell most;
        (void)sample(m_air, static_cast<float>(i) - scale * d.u, static_cast<float>(j) - scale * d.v,
            static_cast<float>(k) - scale * d.w, &least, &most);
        const Cell back = sample(m_guess, static_cast<float>(i) + scale * d.u, static_cast<float>(j) + scale * d.v,
            static_cast<float>(k) + scale * d.w, nullptr, nullptr);
        const Cell& guess = m_guess[at(i, j, k)];
        const Cell& here = m_air[at(i, j, k)];
        m_next[at(i, j, k)] = {std::clamp(guess.u + 0.5F * (here.u - back.u), least.u, most.u),
            std::clamp(guess.v + 0.5F * (here.v - back.v), least.v, most.v),
            std::clamp(guess.w + 0.5F * (here.w - back.w), least.w, most.w),
            std::clamp(guess.heat + 0.5F * (here.heat - back.heat), least.heat, most.heat)};
    });
    m_air.swap(m_next);
}

void ObviousAir::project()
{
    std::fill(m_pressure.begin(), m_pressure.end(), 0.0F);
    forCells([&](int i, int j, int k) {
        m_divergence[at(i, j, k)] = 0.5F
            * (m_air[at(i + 1, j, k)].u - m_air[at(i - 1, j, k)].u + m_air[at(i, j + 1, k)].v - m_air[at(i, j - 1, k)].v
                + m_air[at(i, j, k + 1)].w - m_air[at(i, j, k - 1)].w);
    });
    // As much work as two V(2, 2) cycles, whose coarser levels add a seventh: the simplest solver would need hundreds
    // of sweeps.
    constexpr int kSweeps = 10;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        forCells([&](int i, int j, int k) {
            const float around = m_pressure[at(i + 1, j, k)] + m_pressure[at(i - 1, j, k)] + m_pressure[at(i, j + 1, k)]
                + m_pressure[at(i, j - 1, k)] + m_pressure[at(i, j, k + 1)] + m_pressure[at(i, j, k - 1)];
            m_pressure[at(i, j, k)] = (around - m_divergence[at(i, j, k)]) / 6.0F;
        });
    }
    forCells([&](int i, int j, int k) {
        Cell& here = m_air[at(i, j, k)];
        here.u -= 0.5F * (m_pressure[at(i + 1, j, k)] - m_pressure[at(i - 1, j, k)]);
        here.v -= 0.5F * (m_pressure[at(i, j + 1, k)] - m_pressure[at(i, j - 1, k)]);
        here.w -= 0.5F * (m_pressure[at(i, j, k + 1)] - m_pressure[at(i, j, k - 1)]);
    });
}

void ObviousAir::step(float dt, float buoyancy)
{
    advect(dt);
    for (Cell& cell : m_air) {
        cell.v += dt * buoyancy * cell.heat;
    }
    project();
}

void ObviousAir::carry(std::vector<Place>& particles, float dt) const
{
    const float scale = dt / m_cell;
    for (Place& p : particles) {
        const Cell here = sample(m_air, p.x, p.y, p.z, nullptr, nullptr);
        const float half = 0.5F * scale;
        const Cell midway =
            sample(m_air, p.x + half * here.u, p.y + half * here.v, p.z + half * here.w, nullptr, nullptr);
        p = {p.x + scale * midway.u, p.y + scale * midway.v, p.z + scale * midway.w};
    }
}

} // namespace fumage::benchmarks
