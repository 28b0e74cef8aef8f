#pragma once

#include "core/lighting/particle_appearance.h"

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace fumage {

/// A regular grid around the cloud whose w axis runs along the light, so that shadows are sums along columns.
struct GridShape {
    Axes axes;
    glm::vec3 origin{0.0F}; ///< of cell (0, 0, 0)'s centre, in the axes, m
    float cell = 1.0F; ///< edge of a cell, m
    float finest = 1.0F; ///< edge that the resolution asks for, m: cells are larger where particles are too few for it
    int nu = 1, nv = 1, nw = 1;

    /// How many cells there are in all.
    [[nodiscard]] std::size_t cells() const
    {
        return static_cast<std::size_t>(nu) * static_cast<std::size_t>(nv) * static_cast<std::size_t>(nw);
    }
};

/// Light that reaches each cell, ready to be multiplied by colours.
struct LightGrid {
    GridShape shape;
    AlignedArray<float> density; ///< extinction, 1/m; u fastest, w slowest
    AlignedArray<float> plain; ///< the same without the detail that is in it; empty: there is none
    /// Four floats a cell: sun with shadow and phase, sky, ground, optical depth towards the sun
    AlignedArray<float> light;
    /// Four floats a cell, empty where there is none: light of sun, sky and ground that smoke has scattered many times
    AlignedArray<float> diffuse;
    AlignedArray<float> fire; ///< one float a cell: light of what glows in the smoke; empty: there is none
    glm::vec3 fireColour{0.0F};
    float fireStrength = 1.0F; ///< that its light is multiplied by

    /// Extinction as the particles have it, 1/m.
    [[nodiscard]] const AlignedArray<float>& densityOfParticles() const { return plain.empty() ? density : plain; }
};

/// What diffuseLight() needs while it works.
struct DiffusionWorkspace {
    /// Cells of one size, u fastest.
    struct Level {
        int nu = 0, nv = 0, nw = 0;
        float cell = 1.0F; ///< edge, m
        AlignedArray<float> depth; ///< extinction times edge
        AlignedArray<float> taken; ///< four floats a cell
        AlignedArray<float> light; ///< four floats a cell

        [[nodiscard]] std::size_t at(int u, int v, int w) const
        {
            return (static_cast<std::size_t>(w) * static_cast<std::size_t>(nv) + static_cast<std::size_t>(v))
                * static_cast<std::size_t>(nu)
                + static_cast<std::size_t>(u);
        }
    };
    std::vector<Level> levels;
};

/// What lightSmoke() needs while it works; kept, so that its memory is allocated once.
struct LightWorkspace {
    AlignedArray<float> sky; ///< one float a cell, before they go into light
    AlignedArray<float> ground;
    AlignedArray<float> air; ///< a line of cells without density: what lies before the first
    AlignedArray<float> soft; ///< four floats a cell, half softened
    DiffusionWorkspace diffusion;
    LightGrid layer; ///< densities of one layer of several
    std::vector<AlignedArray<std::uint32_t>> partial; ///< one fixed-point density a worker
};

} // namespace fumage
