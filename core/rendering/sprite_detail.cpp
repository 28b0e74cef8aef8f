#include "core/rendering/sprite_detail.h"

#include "core/base/hash.h"
#include "core/rendering/sprite_job.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace fumage {

namespace {

/// How far into the light the noise is looked at for relief, in waves.
constexpr float kReliefReach = 0.032F;
/// What a relief of 1 multiplies the difference by.
constexpr float kRelief = 2.0F;
/// How much less light from all around there is in folds, and how much more of the glow: a crust is dark, its cracks
/// glow.
constexpr float kOcclusion = 0.3F;
constexpr float kGlowInFolds = 0.5F;

/// Between the centres of eight cells.
float cellsAt(const GridShape& shape, const float* cells, const glm::vec3& place)
{
    const glm::vec3 along{glm::dot(place, shape.axes.u), glm::dot(place, shape.axes.v), glm::dot(place, shape.axes.w)};
    const glm::vec3 last = glm::max(glm::vec3(shape.nu, shape.nv, shape.nw) - 1.0F, glm::vec3(0.0F));
    const glm::vec3 inside = glm::clamp((along - shape.origin) / shape.cell, glm::vec3(0.0F), last);
    const glm::vec3 low = glm::max(glm::vec3(0.0F), glm::min(glm::floor(inside), last - 1.0F));
    const glm::vec3 t = inside - low;
    const auto nu = static_cast<std::size_t>(shape.nu);
    const std::size_t plane = nu * static_cast<std::size_t>(shape.nv);
    const std::size_t up = shape.nv > 1 ? nu : 0;
    const std::size_t in = shape.nw > 1 ? plane : 0;
    const std::size_t beside = shape.nu > 1 ? 1 : 0;
    const float* at = cells + static_cast<std::size_t>(low.z) * plane + static_cast<std::size_t>(low.y) * nu
        + static_cast<std::size_t>(low.x);
    const auto row = [&](std::size_t offset) { return at[offset] + (at[offset + beside] - at[offset]) * t.x; };
    const auto side = [&](std::size_t offset) {
        const float below = row(offset);
        return below + (row(offset + up) - below) * t.y;
    };
    const float front = side(0);
    return front + (side(in) - front) * t.z;
}

/// The mean of a factor on alpha over even noise t: 0 below y = 1 + s t = -1/2, (y + 1/2)^2 / 2 up to 1/2, and y above.
float meanOfFactor(float s)
{
    constexpr float kHalf = 0.5F;
    if (s <= kHalf) {
        return 1.0F;
    }
    const float low = std::max(0.0F, 1.0F - s + kHalf);
    const float high = 1.0F + s;
    return ((1.0F - low * low * low) / 6.0F + 0.5F * (high * high - kHalf * kHalf)) / (2.0F * s);
}

/// Where a sprite reads one phase.
/// @param toLight its way, m @return whether it shows any octave
bool findPhase(const SpriteDetailJob& job, const glm::vec3& place, std::uint32_t key, float metresPerPixel,
    float relief, std::size_t which, SpriteDetail& out)
{
    const DetailField& detail = *job.detail;
    const AdvectedPhase& phase = (*detail.phases)[which];
    const AdvectedPlace from = advectedPlace(phase.map, place);
    const std::array<float, DetailTexture::kLevels> shares = detail.octaveShares(from.slope, metresPerPixel);
    constexpr std::uint32_t kOctaveStream = 0x0c7a;
    const float draw = unitFloat(streamBits(key, kOctaveStream));
    const auto octaves =
        static_cast<int>(std::count_if(shares.begin(), shares.end(), [&](float share) { return draw < share; }));
    if (octaves == 0) {
        return false;
    }
    const int level = octaves - 1;
    const auto size = static_cast<float>(DetailTexture::size(level));
    const float texelsPerMetre = size * detail.tilesPerMetre;
    glm::vec3 at = from.place * texelsPerMetre + detail.shift[which] * size;
    // Each sprite reads a little beside its place: together they smooth what is linear over a texel alone.
    constexpr std::uint32_t kJitterStream = 0x717e;
    at += glm::vec3(unitFloat(streamBits(key, kJitterStream)), unitFloat(streamBits(key, kJitterStream + 1)),
              unitFloat(streamBits(key, kJitterStream + 2)))
        - 0.5F;
    at -= glm::floor(at / size) * size;
    const View& view = job.batch->view;
    const glm::mat3 texels = from.slope * texelsPerMetre;
    const glm::vec3 u = texels * view.right * metresPerPixel;
    const glm::vec3 v = texels * view.up * -metresPerPixel;
    const glm::vec3 light = texels * job.lightDirection * (kReliefReach * detail.wave);
    SpriteDetail::Phase& to = out.phases[which];
    for (int axis = 0; axis < 3; ++axis) {
        to.at[axis] = at[axis];
        to.u[axis] = u[axis];
        to.v[axis] = v[axis];
    }
    to.weight = phase.weight;
    const LightBytes bytes(light.x, light.y, light.z);
    to.light = bytes.packed;
    to.relief = phase.weight * kRelief * relief * bytes.scale;
    out.levels[which] = static_cast<std::uint8_t>(level);
    return true;
}

void findDetail(const SpriteDetailJob& job, std::size_t i)
{
    SpriteDetail& out = job.batch->details[i];
    out.shown[0] = out.shown[1] = 0;
    const DetailField& detail = *job.detail;
    const Particles& particles = *job.particles;
    const glm::vec3 place{particles.x[i], particles.y[i], particles.z[i]};
    const float body = cellsAt(job.light->shape, job.light->body.data(), place);
    out.strength = detail.strength * (detail.edge + (1.0F - detail.edge) * body);
    constexpr float kNothing = 0.01F;
    if (!(out.strength > kNothing)) {
        return;
    }
    // Relief goes earlier than strength where smoke is thin.
    const float left = 0.5F * detail.edge + (1.0F - 0.5F * detail.edge) * body;
    const View& view = job.batch->view;
    const float metresPerPixel = glm::dot(place - view.eye, view.forward) / view.focal;
    for (std::size_t which = 0; which < out.phases.size(); ++which) {
        out.shown[which] = (*detail.phases)[which].weight >= kMinPhaseWeight
                && findPhase(job, place, particles.key[i], metresPerPixel, detail.relief * left, which, out)
            ? 1
            : 0;
    }
    const float first = (*detail.phases)[0].weight;
    const float second = (*detail.phases)[1].weight;
    PhaseBlend blend;
    if (out.shown[0] != 0 && out.shown[1] != 0) {
        blend = PhaseBlend(first, second);
    } else if (first < kMinPhaseWeight || second < kMinPhaseWeight) {
        blend = PhaseBlend(std::max(first, second), 0.0F);
    }
    out.gain = blend.gain;
    out.flat = blend.flat;
    out.bend = blend.bend;
    out.perMean = 1.0F / meanOfFactor(out.strength);
    const float glowing = out.around;
    out.around = left * detail.relief * ((1.0F - glowing) * kOcclusion - glowing * kGlowInFolds);
    out.screenRelief = kRelief * detail.relief * left * kReliefReach * detail.wave / metresPerPixel;
}

} // namespace

void findSpriteDetail(const SpriteDetailJob& job, std::size_t begin)
{
    for (std::size_t i = begin; i < begin + kSpriteBlock; ++i) {
        if (job.batch->depth[i] != SpriteBatch::kHidden) {
            findDetail(job, i);
        }
    }
}

} // namespace fumage
