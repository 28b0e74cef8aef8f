#pragma once

#include "core/lighting/particle_appearance.h"

#include <vector>

namespace fumage {

/// Numbers at the cells of a grid, u fastest.
struct GridField {
    int nu = 0, nv = 0, nw = 0;
    AlignedArray<float> values;

    void resize(int u, int v, int w);
    /// The cells along u at one v and w.
    [[nodiscard]] float* line(int v, int w) { return values.data() + lineAt(v, w); }
    [[nodiscard]] const float* line(int v, int w) const { return values.data() + lineAt(v, w); }

private:
    [[nodiscard]] std::size_t lineAt(int v, int w) const
    {
        return (static_cast<std::size_t>(w) * static_cast<std::size_t>(nv) + static_cast<std::size_t>(v))
            * static_cast<std::size_t>(nu);
    }
};

/// What lightByFire() needs while it works; kept, so that its memory is allocated once.
struct FireWorkspace {
    /// A field at cells of one size, and on the way to those of twice that.
    struct Level {
        GridField glow; ///< radiance given off, 1/m of it
        GridField density; ///< extinction, 1/m
        GridField light;
        GridField halfU, halfV;
    };
    /// What the particles of a layer give off.
    struct Layer {
        Appearance glowing; ///< of each particle what it gives off, as if that were its opacity
        AlignedArray<float> heat; ///< of each particle, as it glows
    };
    std::vector<Layer> layers; ///< those that glow
    std::vector<Level> levels;
};

} // namespace fumage
