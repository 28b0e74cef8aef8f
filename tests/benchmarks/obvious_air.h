#pragma once

#include <vector>

namespace fumage::benchmarks {

/// The air as one writes it down first: plain loops over plain arrays in floats, one number at a time. The same method
/// with the same number of traces and of sweeps; no obstacles, no source, no confinement.
class ObviousAir {
public:
    ObviousAir(int nx, int ny, int nz, float cell);
    /// Warms a ball of the air, so that there is something to move.
    void heat();
    void step(float dt, float buoyancy);

    struct Place {
        float x, y, z; ///< in cells
    };
    /// Takes particles along, second order; without any detail below the grid.
    void carry(std::vector<Place>& particles, float dt) const;

private:
    struct Cell {
        float u = 0.0F, v = 0.0F, w = 0.0F, heat = 0.0F;
    };
    [[nodiscard]] std::size_t at(int i, int j, int k) const;
    template <class Visit>
    void forCells(const Visit& visit) const;
    [[nodiscard]] Cell sample(const std::vector<Cell>& from, float x, float y, float z, Cell* least, Cell* most) const;
    void advect(float dt);
    void project();

    int m_nx, m_ny, m_nz;
    float m_cell;
    std::vector<Cell> m_air, m_guess, m_next;
    std::vector<float> m_pressure, m_divergence;
};

} // namespace fumage::benchmarks
