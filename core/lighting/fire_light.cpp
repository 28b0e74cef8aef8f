#include "core/lighting/fire_light.h"

#include "core/base/parallel.h"
#include "core/lighting/fire_light_kernel.h"
#include "core/lighting/grid_planes.h"
#include "core/lighting/light_grid.h"
#include "core/scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace fumage {

void GridField::resize(int u, int v, int w)
{
    nu = u;
    nv = v;
    nw = w;
    values.resize(static_cast<std::size_t>(u) * static_cast<std::size_t>(v) * static_cast<std::size_t>(w));
}

namespace {

FireJob fireJob(const Frame& frame, const Effect& effect, const GlowColours& colours)
{
    FireJob job;
    job.glow = GlowTable(effect, colours);
    std::transform(colours.begin(), colours.end(), job.brightness.begin(),
        [&](const glm::vec3& colour) { return effect.glow.emission * glm::dot(colour, kLuminance); });
    job.hotCore = effect.glow.hotCore;
    job.step = static_cast<std::int32_t>(frame.step);
    job.dt = frame.model->schedule().dt;
    job.bornBetweenSteps = frame.model->schedule().betweenSteps;
    return job;
}

/// What the particles of a layer give off in all, and how hot they are in the mean, weighted by it: one order of the
/// sum for any number of threads and lanes.
struct GivenOff {
    double sum = 0.0;
    double heat = 0.0;

    explicit GivenOff(const FireWorkspace::Layer& layer)
    {
        for (std::size_t i = 0; i < layer.heat.size(); ++i) {
            const float radius = layer.glowing.radius[i];
            const double given = layer.glowing.alpha[i] * (radius * radius);
            sum += given;
            heat += given * layer.heat[i];
        }
    }
    [[nodiscard]] float meanHeat() const { return sum > 0.0 ? static_cast<float>(heat / sum) : 0.0F; }
};

/// Calls body(w) for each plane.
template <class Body>
void forPlanes(const GridField& field, const Body& body)
{
    forGridPlanes(field.nw, field.values.size(), body);
}

/// Cells along an axis of a grid of twice the size: their centres lie half a cell before the first one and after the
/// last.
int halved(int count)
{
    return (count + 1) / 2 + 1;
}

/// (1 3 3 1) / 8 around each cell of twice the size, along u. What lies outside of a field is 0.
void halveAlongU(const GridField& from, GridField& to)
{
    to.resize(halved(from.nu), from.nv, from.nw);
    forPlanes(from, [&](int w) {
        for (int v = 0; v < from.nv; ++v) {
            const float* in = from.line(v, w);
            float* out = to.line(v, w);
            const auto at = [&](int u) { return u < 0 || u >= from.nu ? 0.0F : in[u]; };
            for (int u = 0; u < to.nu; ++u) {
                out[u] = 0.125F * (at(2 * u - 2) + at(2 * u + 1)) + 0.375F * (at(2 * u - 1) + at(2 * u));
            }
        }
    });
}

/// The same across lines.
/// @param line of cells along u of the field, by its place along the axis; outside of it a line of zeros
template <class Line>
void halveLines(int count, int first, const Line& line, float* out)
{
    const float* a = line(first - 2);
    const float* b = line(first - 1);
    const float* c = line(first);
    const float* d = line(first + 1);
    for (int u = 0; u < count; ++u) {
        out[u] = 0.125F * (a[u] + d[u]) + 0.375F * (b[u] + c[u]);
    }
}

/// @param nothing zeros, a line or more of them
void halve(const GridField& from, const AlignedArray<float>& nothing, FireWorkspace::Level& room, GridField& to)
{
    halveAlongU(from, room.halfU);
    const GridField& u = room.halfU;
    room.halfV.resize(u.nu, halved(u.nv), u.nw);
    forPlanes(room.halfV, [&](int w) {
        for (int v = 0; v < room.halfV.nv; ++v) {
            halveLines(
                u.nu, 2 * v, [&](int at) { return at < 0 || at >= u.nv ? nothing.data() : u.line(at, w); },
                room.halfV.line(v, w));
        }
    });
    const GridField& uv = room.halfV;
    to.resize(uv.nu, uv.nv, halved(uv.nw));
    forPlanes(to, [&](int w) {
        for (int v = 0; v < to.nv; ++v) {
            halveLines(
                uv.nu, 2 * w, [&](int at) { return at < 0 || at >= uv.nw ? nothing.data() : uv.line(v, at); },
                to.line(v, w));
        }
    });
}

/// The nearer of the two larger cells beside a cell, and the other.
struct Beside {
    int near = 0;
    int far = 0;
};

Beside beside(int at)
{
    return at % 2 == 0 ? Beside{at / 2, at / 2 + 1} : Beside{at / 2 + 1, at / 2};
}

/// Adds a field of larger cells to one of half their size, linearly between their centres.
void addDoubled(const GridField& from, GridField& to)
{
    forPlanes(to, [&](int plane) {
        const Beside w = beside(plane);
        for (int v = 0; v < to.nv; ++v) {
            const Beside b = beside(v);
            const float* nearNear = from.line(b.near, w.near);
            const float* farNear = from.line(b.far, w.near);
            const float* nearFar = from.line(b.near, w.far);
            const float* farFar = from.line(b.far, w.far);
            const auto at = [&](int u) {
                return 0.5625F * nearNear[u] + 0.1875F * (farNear[u] + nearFar[u]) + 0.0625F * farFar[u];
            };
            float* out = to.line(v, plane);
            for (int u = 0; u < to.nu; ++u) {
                const Beside c = beside(u);
                out[u] += 0.75F * at(c.near) + 0.25F * at(c.far);
            }
        }
    });
}

/// What a level adds: its glow, by the weight of its octave, through the smoke that lies around.
/// @param deviation of the Gaussian that the level is blurred by, m
void fillLight(FireWorkspace::Level& level, float deviation, float extinction)
{
    constexpr float kOctave = 0.69314718F; // of d(ln s)
    constexpr float kHalfPiRoot = 1.2533141F; // sqrt(pi / 2)
    const float weight = kHalfPiRoot * kOctave * deviation;
    // Light that has come r has the mean deviation sqrt(pi / 2) r: in thin, even smoke this takes as much as the way
    // itself.
    const float depthOfDensity = extinction * deviation / kHalfPiRoot;
    level.light.resize(level.glow.nu, level.glow.nv, level.glow.nw);
    const std::size_t plane = static_cast<std::size_t>(level.glow.nu) * static_cast<std::size_t>(level.glow.nv);
    forPlanes(level.glow, [&](int w) {
        const std::size_t begin = static_cast<std::size_t>(w) * plane;
        for (std::size_t i = begin; i < begin + plane; ++i) {
            const float depth = depthOfDensity * level.density.values[i];
            // exp(-depth) to a few per cent, by operations that have the same bits everywhere.
            const float through = 1.0F / (1.0F + depth * (1.0F + depth * (0.5F + depth * (1.0F / 6.0F))));
            level.light.values[i] = weight * level.glow.values[i] * through;
        }
    });
}

/// Blurs the glow of the first level over all octaves, and adds them up in it.
/// @param nothing zeros, a line of the first level or more of them
void spread(FireWorkspace& room, const AlignedArray<float>& nothing, float cell, float extinction)
{
    // Deviation of a level in its own cells: what splatting, halving and linear interpolation blur.
    constexpr float kDeviation = 0.70710678F;
    constexpr float kFirstDeviation = 0.57735027F; // of splatting and reading alone
    constexpr int kSmallest = 4;
    std::size_t last = 0;
    const auto largestOf = [&](std::size_t level) {
        return std::max({room.levels[level].glow.nu, room.levels[level].glow.nv, room.levels[level].glow.nw});
    };
    for (; largestOf(last) > kSmallest; ++last) {
        if (room.levels.size() <= last + 1) {
            room.levels.resize(last + 2);
        }
        halve(room.levels[last].glow, nothing, room.levels[last], room.levels[last + 1].glow);
        halve(room.levels[last].density, nothing, room.levels[last], room.levels[last + 1].density);
    }
    for (std::size_t level = last + 1; level-- > 0;) {
        const float size = std::ldexp(cell, static_cast<int>(level));
        fillLight(room.levels[level], size * (level == 0 ? kFirstDeviation : kDeviation), extinction);
        if (level < last) {
            addDoubled(room.levels[level + 1].light, room.levels[level].light);
        }
    }
}

bool givesLight(const LitLayer& layer)
{
    return isLitByFire(layer.effect->glow) && layer.appearance->count > 0;
}

/// Finds what the particles of a layer give off. @return its colour, of luminance 1, times what it gives off
glm::dvec4 findGlowing(const LitLayer& layer, float strongest, const LightGrid& light, FireWorkspace::Layer& out)
{
    const std::size_t padded = layer.appearance->radius.size();
    out.glowing.radius.resize(padded);
    out.glowing.alpha.resize(padded);
    out.heat.resize(padded);
    const GlowColours colours = glowColours(layer.effect->glow);
    FireJob job = fireJob(*layer.frame, *layer.effect, colours);
    job.strength = layer.effect->glow.fireLight / strongest;
    out.glowing.largestMass = 0.0F;
    std::mutex comparing;
    parallelFor(layer.frame->particles.chunks(), [&](std::size_t chunk) {
        const float largest = findFireOfChunk(job, *layer.frame, *layer.appearance, light, chunk, out);
        const std::lock_guard lock(comparing);
        out.glowing.largestMass = std::max(out.glowing.largestMass, largest);
    });
    out.glowing.count = layer.appearance->count;
    out.glowing.cover.mean = layer.appearance->cover.mean;
    const GivenOff given(out);
    const auto entry = static_cast<std::size_t>(given.meanHeat() * static_cast<float>(kGlowTableSize - 1));
    const float brightness = job.brightness[entry];
    if (!(out.glowing.largestMass > 0.0F) || !(brightness > 0.0F)) {
        return {};
    }
    const glm::vec3 colour = colours[entry] * (layer.effect->glow.emission / brightness);
    return {glm::dvec3(colour), given.sum * static_cast<double>(out.glowing.cover.mean)};
}

} // namespace

bool isLitByFire(const Glow& glow)
{
    return glow.emission > 0.0F && glow.fireLight > 0.0F;
}

void lightByFire(LitLayers layers, FireWorkspace& room, LightWorkspace& splats, LightGrid& light)
{
    light.fire.clear();
    const auto glowing = static_cast<std::size_t>(std::count_if(layers.begin(), layers.end(), givesLight));
    if (glowing == 0 || light.shape.cells() == 1) {
        return;
    }
    light.fireStrength = 0.0F;
    for (const LitLayer& layer : layers) {
        light.fireStrength =
            givesLight(layer) ? std::max(light.fireStrength, layer.effect->glow.fireLight) : light.fireStrength;
    }
    room.layers.resize(std::max(room.layers.size(), glowing)); // what is there keeps its memory
    std::array<LitLayer, kMaxLayers> sources;
    std::array<glm::dvec4, kMaxLayers> given;
    std::size_t count = 0;
    double sum = 0.0;
    for (const LitLayer& layer : layers) {
        if (givesLight(layer)) {
            FireWorkspace::Layer& own = room.layers[count];
            given[count] = findGlowing(layer, light.fireStrength, light, own);
            sources[count] = {layer.frame, layer.effect, &own.glowing, nullptr};
            sum += given[count].w;
            ++count;
        }
    }
    if (!(sum > 0.0)) {
        return;
    }
    light.fireColour = glm::vec3(0.0F);
    for (const glm::dvec4& each : std::span(given).first(count)) {
        light.fireColour += glm::vec3(each) * static_cast<float>(each.w / sum);
    }
    if (room.levels.empty()) {
        room.levels.resize(1);
    }
    FireWorkspace::Level& finest = room.levels.front();
    finest.glow.resize(light.shape.nu, light.shape.nv, light.shape.nw);
    finest.density.resize(light.shape.nu, light.shape.nv, light.shape.nw);
    splatParticles(std::span(sources).first(count), light.shape, splats, finest.glow.values);
    std::copy_n(light.density.begin(), light.shape.cells(), finest.density.values.begin());
    spread(room, splats.air, light.shape.cell, layers.front().effect->light.shadow);
    light.fire = room.levels.front().light.values;
}

} // namespace fumage
