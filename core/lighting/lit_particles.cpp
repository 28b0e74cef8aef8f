#include "core/lighting/lit_particles.h"

#include "core/base/parallel.h"
#include "core/lighting/lit_kernel.h"
#include "core/lighting/soft_light.h"

#include <algorithm>

namespace fumage {

namespace {

/// Calls body(begin) for each block of particles.
template <class Body>
void forBlocks(const Particles& particles, const Body& body)
{
    parallelFor(particles.chunks(), [&](std::size_t chunk) {
        for (std::size_t block = 0; block < Particles::kChunk; block += kLitBlock) {
            body(chunk * Particles::kChunk + block);
        }
    });
}

/// The difference of the cells on either side of one, on a line of a grid; the ends of the line go on beyond it.
/// @param at place on the line @param step from one cell of it to the next
float fall(const float* cell, int at, int count, std::size_t step)
{
    const float before = at > 0 ? *(cell - step) : *cell;
    const float after = at + 1 < count ? *(cell + step) : *cell;
    return before - after;
}

void findOutwardsOfPlane(const LightGrid& grid, int w, AlignedArray<float>& out)
{
    const GridShape& shape = grid.shape;
    const auto line = static_cast<std::size_t>(shape.nu);
    const std::size_t plane = line * static_cast<std::size_t>(shape.nv);
    std::size_t i = static_cast<std::size_t>(w) * plane;
    for (int v = 0; v < shape.nv; ++v) {
        for (int u = 0; u < shape.nu; ++u, ++i) {
            const float* cell = grid.densityOfParticles().data() + i;
            out[4 * i] = fall(cell, u, shape.nu, 1);
            out[4 * i + 1] = fall(cell, v, shape.nv, line);
            out[4 * i + 2] = fall(cell, w, shape.nw, plane);
            out[4 * i + 3] = 0.0F;
        }
    }
}

} // namespace

void findLitColours(const Frame& frame, const SampledEffect& effect, const Appearance& appearance,
    const LightGrid& grid, std::vector<glm::vec4>& out)
{
    LitJob job;
    job.particles = &frame.particles;
    job.appearance = &appearance;
    job.grid = &grid;
    job.colours = particleLight(effect, grid);
    job.step = static_cast<std::int32_t>(frame.step);
    job.dt = frame.model->schedule().dt;
    job.bornBetweenSteps = frame.model->schedule().betweenSteps;
    out.resize(frame.particles.x.size());
    forBlocks(frame.particles, [&](std::size_t begin) { litColoursOfBlock(job, begin, out.data() + begin); });
}

void findNormals(const Frame& frame, const Appearance& appearance, const LightGrid& grid, NormalWorkspace& room,
    std::vector<glm::vec3>& out)
{
    constexpr std::size_t kChannels = 4;
    out.resize(frame.particles.x.size());
    if (appearance.count == 0) {
        std::fill(out.begin(), out.end(), glm::vec3(0.0F));
        return;
    }
    room.outwards.resize(grid.shape.cells() * kChannels);
    parallelFor(static_cast<std::size_t>(grid.shape.nw),
        [&](std::size_t w) { findOutwardsOfPlane(grid, static_cast<int>(w), room.outwards); });
    softenCells(grid.shape, kChannels, room.outwards, room.room);
    const NormalJob job{&frame.particles, &appearance, &grid.shape, &room.outwards};
    forBlocks(frame.particles, [&](std::size_t begin) { normalsOfBlock(job, begin, out.data() + begin); });
}

} // namespace fumage
