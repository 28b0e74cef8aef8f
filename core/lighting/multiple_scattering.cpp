#include "core/lighting/multiple_scattering.h"

#include "core/base/math.h"
#include "core/effect/effect.h"
#include "core/lighting/grid_planes.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace fumage {

namespace {

using Level = DiffusionWorkspace::Level;

constexpr std::size_t kChannels = 4;
constexpr float kAbsorbed = 0.005F; // of what is scattered: a body of smoke is white, and ends

void resize(Level& level, int nu, int nv, int nw, float cell)
{
    level.nu = nu;
    level.nv = nv;
    level.nw = nw;
    level.cell = cell;
    const std::size_t cells =
        static_cast<std::size_t>(nu) * static_cast<std::size_t>(nv) * static_cast<std::size_t>(nw);
    level.depth.resize(cells);
    level.taken.resize(cells * kChannels);
    level.light.resize(cells * kChannels);
}

Float4 at(const AlignedArray<float>& values, std::size_t cell)
{
    return loadFloats<Float4>(values.data() + cell * kChannels);
}

void put(AlignedArray<float>& values, std::size_t cell, Float4 value)
{
    std::memcpy(values.data() + cell * kChannels, &value, sizeof(value));
}

/// Calls body(w) for each plane.
template <class Body>
void forPlanes(const Level& level, const Body& body)
{
    forGridPlanes(level.nw, level.depth.size(), body);
}

/// A cell of twice the size has the mean extinction of eight, and takes what they take over four times the face.
void coarsen(const Level& from, Level& to)
{
    const auto half = [](int count) { return (count + 1) / 2; };
    resize(to, half(from.nu), half(from.nv), half(from.nw), 2.0F * from.cell);
    forPlanes(to, [&](int w) {
        std::size_t cell = to.at(0, 0, w);
        for (int v = 0; v < to.nv; ++v) {
            for (int u = 0; u < to.nu; ++u, ++cell) {
                float depth = 0.0F;
                Float4 taken{};
                for (int k = 2 * w; k < std::min(2 * w + 2, from.nw); ++k) {
                    for (int j = 2 * v; j < std::min(2 * v + 2, from.nv); ++j) {
                        for (int i = 2 * u; i < std::min(2 * u + 2, from.nu); ++i) {
                            depth += from.depth[from.at(i, j, k)];
                            taken += at(from.taken, from.at(i, j, k));
                        }
                    }
                }
                to.depth[cell] = 0.25F * depth; // of eight, over twice the way
                put(to.taken, cell, 0.25F * taken);
            }
        }
    });
}

/// The larger cell that a cell lies in, and the next one on its side, if there is one.
struct Beside {
    int own;
    int next;

    Beside(int at, int count)
        : own(at / 2)
        , next(std::clamp(own + (at % 2 == 0 ? -1 : 1), 0, count - 1))
    {
    }
};

/// Light of larger cells, linearly between their centres: where finer cells begin.
void refine(const Level& from, Level& to)
{
    constexpr float kNext = 0.25F;
    const auto mix = [](Float4 own, Float4 next) { return own + kNext * (next - own); };
    forPlanes(to, [&](int plane) {
        const Beside w(plane, from.nw);
        std::size_t cell = to.at(0, 0, plane);
        for (int line = 0; line < to.nv; ++line) {
            const Beside v(line, from.nv);
            const auto column = [&](int u) {
                const auto row = [&](int k) {
                    return mix(at(from.light, from.at(u, v.own, k)), at(from.light, from.at(u, v.next, k)));
                };
                return mix(row(w.own), row(w.next));
            };
            for (int i = 0; i < to.nu; ++i, ++cell) {
                const Beside u(i, from.nu);
                put(to.light, cell, mix(column(u.own), column(u.next)));
            }
        }
    });
}

/// Sets every other cell of a plane to what it would be between its neighbours.
/// @param extinction factor on optical depths @param clear the shortest way from a cell to the next, through clear air
void balancePlane(Level& level, Float4 extinction, float clear, int odd, int w)
{
    constexpr float kOverRelaxation = 1.5F; // Young 1954: fewer sweeps
    const Float4 throughAir = 1.0F / (Float4{} + clear);
    const auto line = static_cast<std::size_t>(level.nu);
    const std::size_t plane = line * static_cast<std::size_t>(level.nv);
    for (int v = 0; v < level.nv; ++v) {
        for (int u = (v + w + odd) % 2; u < level.nu; u += 2) {
            const std::size_t cell = level.at(u, v, w);
            const bool isClear = !(level.depth[cell] > 0.0F);
            const Float4 own = extinction * level.depth[cell];
            Float4 given = at(level.taken, cell);
            Float4 passed = kAbsorbed * own;
            const auto beside = [&](bool inside, std::size_t other) {
                constexpr float kThreeHalves = 1.5F; // 3 times the mean of two
                constexpr float kOut = 2.0F; // half of phi goes out where nothing comes in (Marshak 1947)
                if (!inside) {
                    passed += 1.0F / (kThreeHalves * own + kOut);
                    return;
                }
                if (isClear && !(level.depth[other] > 0.0F)) { // as most cells of a grid are: no division
                    passed += throughAir;
                    given += throughAir * at(level.light, other);
                    return;
                }
                const Float4 way = kThreeHalves * (own + extinction * level.depth[other]);
                const Float4 through = 1.0F / (way > clear ? way : Float4{} + clear);
                passed += through;
                given += through * at(level.light, other);
            };
            beside(u > 0, cell - 1);
            beside(u + 1 < level.nu, cell + 1);
            beside(v > 0, cell - line);
            beside(v + 1 < level.nv, cell + line);
            beside(w > 0, cell - plane);
            beside(w + 1 < level.nw, cell + plane);
            const Float4 light = at(level.light, cell);
            const Float4 better = light + kOverRelaxation * (given / passed - light);
            put(level.light, cell, better > 0.0F ? better : Float4{});
        }
    }
}

/// Red and black cells in turn: each looks at none of its own colour, so that their order does not matter.
void balance(Level& level, Float4 extinction, float clearAir, int sweeps)
{
    for (int half = 0; half < 2 * sweeps; ++half) {
        forPlanes(level, [&](int w) { balancePlane(level, extinction, clearAir * level.cell, half % 2, w); });
    }
}

/// What a cell takes of light, over what there is of it in its middle: exp(x / 2) - exp(-x / 2) for a depth of x.
float takenOf(float depth)
{
    constexpr float kNothingComesThrough = 20.0F;
    const float in = portableExp(std::min(0.5F * depth, kNothingComesThrough));
    return in - 1.0F / in;
}

/// Calls body(cell, depth) for each cell and its optical depth.
template <class Body>
void forCells(const LightGrid& grid, const Body& body)
{
    const std::size_t plane = grid.shape.cells() / static_cast<std::size_t>(grid.shape.nw);
    forGridPlanes(grid.shape.nw, grid.shape.cells(), [&](int w) {
        const std::size_t first = static_cast<std::size_t>(w) * plane;
        for (std::size_t cell = first; cell < first + plane; ++cell) {
            body(cell, grid.density[cell] * grid.shape.cell);
        }
    });
}

} // namespace

void diffuseLight(const GridShape& shape, const AlignedArray<float>& density, Float4 extinction,
    DiffusionWorkspace& room, AlignedArray<float>& light)
{
    constexpr std::size_t kLevels = 6; // cells of 1 to 32: no more than ten of the largest along the longest edge
    constexpr std::array<int, kLevels> kSweeps{4, 5, 6, 8, 12, 16};
    constexpr float kClearAir = 8.0F; // of which a third is its optical depth along the longest edge
    room.levels.resize(kLevels);
    Level& finest = room.levels.front();
    resize(finest, shape.nu, shape.nv, shape.nw, shape.cell);
    std::transform(density.begin(), density.begin() + static_cast<std::ptrdiff_t>(shape.cells()), finest.depth.begin(),
        [&](float extinctionOfCell) { return extinctionOfCell * shape.cell; });
    finest.taken.swap(light);
    for (std::size_t i = 1; i < kLevels; ++i) {
        coarsen(room.levels[i - 1], room.levels[i]);
    }
    std::fill(room.levels.back().light.begin(), room.levels.back().light.end(), 0.0F);
    const float clearAir = kClearAir / (shape.cell * static_cast<float>(std::max({shape.nu, shape.nv, shape.nw})));
    for (std::size_t i = kLevels; i-- > 0;) {
        if (i + 1 < kLevels) {
            refine(room.levels[i + 1], room.levels[i]);
        }
        balance(room.levels[i], extinction, clearAir, kSweeps[i]);
    }
    light.swap(finest.light);
}

float shareOfSun(float multiple)
{
    constexpr float kFurtherScatterings = 3.0F; // of a thick body, over the first
    return 1.0F / (1.0F + kFurtherScatterings * multiple);
}

void scatterManyTimes(const Light& light, LightWorkspace& room, LightGrid& grid)
{
    grid.diffuse.clear();
    if (!(light.multipleScattering > 0.0F) || grid.shape.cells() == 1) {
        return;
    }
    const float share = shareOfSun(light.multipleScattering);
    const Float4 weights = light.multipleScattering * Float4{share * light.intensity, 1.0F, 1.0F, 0.0F};
    grid.diffuse.resize(grid.light.size());
    forCells(grid, [&](std::size_t cell, float depth) {
        Float4 taken{};
        if (depth > 0.0F) {
            const Float4 here = at(grid.light, cell);
            const float ambient = takenOf(depth * light.occlusion);
            const float sun = portableExp(-here[3]) * takenOf(depth * light.shadow);
            taken = weights * Float4{sun, here[1] * ambient, here[2] * ambient, 0.0F};
        }
        put(grid.diffuse, cell, taken);
        grid.light[cell * kChannels] *= share;
    });
    const Float4 extinction{light.shadow, light.occlusion, light.occlusion, 0.0F};
    diffuseLight(grid.shape, grid.density, extinction, room.diffusion, grid.diffuse);
}

void addScatteredManyTimes(const Light& light, const LightGrid& grid, LightWorkspace& room,
    AlignedArray<float>& through, AlignedArray<float>& to)
{
    const float share = shareOfSun(light.multipleScattering);
    forCells(grid, [&](std::size_t cell, float depth) {
        const float taken = light.multipleScattering * takenOf(depth * light.shadow);
        put(through, cell, taken * at(through, cell));
    });
    const Float4 extinction{light.shadow, light.shadow, light.shadow, light.shadow};
    diffuseLight(grid.shape, grid.density, extinction, room.diffusion, through);
    forCells(
        grid, [&](std::size_t cell, float /*depth*/) { put(to, cell, share * (at(to, cell) + at(through, cell))); });
}

} // namespace fumage
