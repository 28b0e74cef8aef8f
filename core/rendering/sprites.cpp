#include "core/rendering/sprites.h"

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/effect/known_parameter.h"
#include "core/lighting/sprite_mask.h"
#include "core/rendering/sprite_detail.h"
#include "core/rendering/sprite_kernel.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace fumage {

namespace {

SpriteStyle makeStyle(const Effect& effect, const View& view)
{
    const Look& look = effect.look;
    SpriteStyle style;
    style.square = look.mask != MaskShape::Disc;
    style.hardness = maskHardness(look);
    style.texture = look.texture;
    style.erosionSoftness = look.erosionSoftness;
    style.textureScale = look.textureScale;
    style.lightX = glm::dot(effect.light.direction, view.right);
    style.lightY = -glm::dot(effect.light.direction, view.up);
    style.relief = look.relief;
    style.roundness = look.roundness;
    if (showsPicture(look)) {
        style.texture = style.relief = style.roundness = 0.0F;
        style.pictureReach = 0.5F * static_cast<float>(SpritePicture::sizeFor(look.picture));
    }
    return style;
}

/// Coarser levels have lost the greys that erosion and its softness cut off: without a balance smoke would be denser
/// from afar.
void fillEvenness(const Look& look, const SpriteTexture& texture, SpriteJob& job)
{
    constexpr float kMax = 2.0F; // where hardly anything is left, a level may have nothing
    constexpr auto kSteps = static_cast<float>(TextureRef::kErosionSteps);
    const auto last = static_cast<std::size_t>(look.erosion * kSteps + 0.5F);
    for (std::size_t step = 0; step <= last; ++step) {
        const float threshold = static_cast<float>(step) / kSteps;
        const float finest = textureLeaves(look, texture.greys(0), threshold);
        for (int level = 0; level <= texture.levels(); ++level) {
            const float here = textureLeaves(look, texture.greys(level), threshold);
            job.evenness[static_cast<std::size_t>(level)][step] = finest < kMax * here ? finest / here : kMax;
        }
    }
}

/// All of a job but what it reads and writes.
SpriteJob makeJob(const Frame& frame, const Effect& effect, int slices, const View& view)
{
    SpriteJob job;
    job.view = view;
    job.step = static_cast<std::int32_t>(frame.step);
    job.dt = frame.model->schedule().dt;
    job.bornBetweenSteps = frame.model->schedule().betweenSteps;
    job.rotationVariance = kPi * effect.look.rotationVariance;
    job.spin = radians(effect.look.spin);
    job.roll = effect.look.roll;
    job.spinVariance = radians(effect.look.spinVariance);
    job.textureSlicesPerSecond = effect.look.textureRate * static_cast<float>(slices) / effect.noise.depth;
    job.erosion = effect.look.erosion;
    job.stretch = effect.look.stretch * effect.timeline.timeScale;
    job.deformation = effect.look.deformation;
    job.deformationLimit = effect.look.deformationLimit;
    job.style = makeStyle(effect, view);
    job.contrast = std::min(1.0F, std::max({job.style.texture, job.style.relief, job.style.roundness}));
    return job;
}

/// Sums up what changes over time and is a rate of each particle's own.
void sumRates(const LitLayer& layer, SpriteJob& job)
{
    const Effect& effect = *layer.effect;
    const Frame& frame = *layer.frame;
    const auto sum = [&](const Parameter& row, float factor, std::vector<float>& out) {
        if (const Track* track = layer.rates->find(row)) {
            sumOverAges(*track, frame.model->schedule(), effect.timeline, frame.step, factor, out);
        }
    };
    if (layer.rates != nullptr) {
        sum(knownParameter("look.spin"), radians(1.0F), job.spun);
        sum(knownParameter("look.spin_variance"), radians(1.0F), job.spunVariance);
        sum(knownParameter("look.texture_rate"), 1.0F / effect.noise.depth, job.boiled);
    }
}

} // namespace

void makeSprites(const LitLayer& layer, const LightGrid& light, const SpriteSurface& surface,
    const AlignedArray<float>& body, const View& view, SpriteBatch& out)
{
    const SpriteTexture& texture = *surface.texture;
    const Effect& effect = *layer.effect;
    const Frame& frame = *layer.frame;
    const DetailField* detail = layer.detail;
    SpriteJob job = makeJob(frame, effect, texture.slices(), view);
    sumRates(layer, job);
    job.particles = &frame.particles;
    job.deforms = frame.particles.deforms();
    job.appearance = layer.appearance;
    job.light = &light;
    job.body = &body;
    job.colours = particleLight(effect, light);
    job.texture = &texture;
    job.picture = surface.picture.get();
    if (detail != nullptr) {
        job.contrast = 0.0F; // a picture in each sprite would blur what all show together
    }
    if (job.style.texture > 0.0F) {
        fillEvenness(effect.look, texture, job);
    }
    job.out = &out;
    const std::size_t padded = frame.particles.x.size();
    out.sprites.resize(padded);
    out.boxes.resize(padded);
    out.depth.resize(padded);
    out.details.resize(detail != nullptr ? padded : 0);
    out.style = job.style;
    out.view = view;
    const SpriteDetailJob of{detail, &frame.particles, effect.light.direction, &out};
    parallelFor(frame.particles.chunks(), [&](std::size_t chunk) {
        for (std::size_t block = 0; block < Particles::kChunk; block += kSpriteBlock) {
            const std::size_t begin = chunk * Particles::kChunk + block;
            if (detail == nullptr) {
                makeSpriteBlock(job, begin, nullptr);
            } else {
                SpriteSurroundings surroundings{};
                makeSpriteBlock(job, begin, &surroundings);
                findSpriteDetail(of, surroundings, begin);
            }
        }
    });
}

} // namespace fumage
