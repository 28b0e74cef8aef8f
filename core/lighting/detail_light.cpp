#include "core/lighting/detail_light.h"

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/lighting/detail_kernel.h"

#include <algorithm>
#include <cmath>

namespace fumage {

namespace {

constexpr std::size_t kPadding = kAlignment / sizeof(float);

/// The most of a cell and of those so many cells away along each axis, which are not beyond the grid.
float mostAround(const GridShape& shape, const float* density, int u, int v, int w, int away)
{
    const auto nu = static_cast<std::size_t>(shape.nu);
    const std::size_t plane = nu * static_cast<std::size_t>(shape.nv);
    const std::size_t at =
        static_cast<std::size_t>(w) * plane + static_cast<std::size_t>(v) * nu + static_cast<std::size_t>(u);
    float most = density[at];
    const auto along = [&](int i, int count, std::size_t stride) {
        const std::size_t way = static_cast<std::size_t>(away) * stride;
        if (i >= away) {
            most = std::max(most, density[at - way]);
        }
        if (i + away < count) {
            most = std::max(most, density[at + way]);
        }
    };
    along(u, shape.nu, 1);
    along(v, shape.nv, nu);
    along(w, shape.nw, plane);
    return most;
}

/// Calls body(u, v, w, index) for the cells of a grid, its planes on all threads.
template <class Body>
void forGridCells(const GridShape& shape, const Body& body)
{
    parallelFor(static_cast<std::size_t>(shape.nw), [&](std::size_t w) {
        std::size_t index = w * static_cast<std::size_t>(shape.nu) * static_cast<std::size_t>(shape.nv);
        for (int v = 0; v < shape.nv; ++v) {
            for (int u = 0; u < shape.nu; ++u, ++index) {
                body(u, v, static_cast<int>(w), index);
            }
        }
    });
}

} // namespace

void putDetailIntoDensity(const DetailField& detail, LightGrid& grid)
{
    grid.plain = grid.density;
    if (!(detail.shadow > 0.0F)) {
        return;
    }
    parallelFor(static_cast<std::size_t>(grid.shape.nw), [&](std::size_t w) {
        for (int v = 0; v < grid.shape.nv; ++v) {
            putDetailIntoLine(detail, detail.shadow, v, static_cast<int>(w), grid);
        }
    });
}

void findBody(const DetailField& detail, const LightGrid& grid, AlignedArray<float>& body)
{
    constexpr float kDepthOfBody = 0.4F;
    const GridShape& shape = grid.shape;
    body.resize(shape.cells() + kPadding);
    const int away = std::max(1, static_cast<int>(std::lround(detail.wave / shape.cell)));
    forGridCells(shape, [&](int u, int v, int w, std::size_t index) {
        const float most = mostAround(shape, grid.densityOfParticles().data(), u, v, w, away);
        body[index] = most > 0.0F ? 1.0F - portableExp(-kDepthOfBody * detail.wave * most) : 0.0F;
    });
}

} // namespace fumage
