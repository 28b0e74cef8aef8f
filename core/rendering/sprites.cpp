#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/rendering/sprites.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/base/hash-inl.h"
#include "core/base/math-inl.h"
#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/lighting/black_body.h"
#include "core/rendering/sprite_mask.h"
#include "core/rendering/sprites.h"
#include "core/simulation/streams.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>

#include <glm/geometric.hpp>

#ifndef FUMAGE_SPRITES_ONCE
#define FUMAGE_SPRITES_ONCE
namespace fumage {

inline constexpr int kColourTableSize = 256;

/// Four floats in one register, on every instruction set: light channels or a colour.
using Float4 = float __attribute__((vector_size(16)));

/// Constants of one pass over the particles.
struct SpriteJob {
    const Particles* particles = nullptr;
    const Appearance* appearance = nullptr;
    const LightGrid* light = nullptr;
    const SpriteTexture* texture = nullptr;
    SpriteBatch* out = nullptr;

    View view;
    std::array<Float4, kColourTableSize> albedo{}; ///< by life
    std::array<Float4, kColourTableSize> emission{}; ///< by heat
    Float4 sun{};
    Float4 sky{};
    Float4 ground{};
    bool glows = false;

    std::int32_t step = 0;
    float dt = 0.0F;
    float rotationVariance = 0.0F; ///< radians
    float spin = 0.0F; ///< radians/s
    float spinVariance = 0.0F;
    float roll = 0.0F; ///< share of the particle's own turn
    float textureSlicesPerSecond = 0.0F;
    float emissionCooling = 0.0F;
    float heatVariance = 0.0F;
    float hotCore = 0.0F;
    float erosion = 0.0F;
    float contrast = 1.0F; ///< of texture and shading inside a sprite, up to 1
    float stretch = 0.0F; ///< s
    SpriteStyle style;
};

/// Screen data of a block of particles, between the vector and the scalar half of the work.
struct SpriteBlock {
    static constexpr std::size_t kSize = 128;
    alignas(64) float x[kSize];
    alignas(64) float y[kSize];
    alignas(64) float depth[kSize];
    alignas(64) float radius[kSize];
    alignas(64) float sine[kSize];
    alignas(64) float cosine[kSize];
    alignas(64) float heat[kSize];
    alignas(64) float slice[kSize];
    alignas(64) float stretchX[kSize]; ///< velocity on the screen, pixels/s
    alignas(64) float stretchY[kSize];
    alignas(64) std::int32_t corner[kSize]; ///< cell of the light grid
    alignas(64) float fu[kSize];
    alignas(64) float fv[kSize];
    alignas(64) float fw[kSize];
};

/// A particle smaller than this is drawn this large and thinner, so that it does not flicker between pixels.
inline constexpr float kSmallestRadius = 1.0F;
/// Nearer than this particles are not drawn, m.
inline constexpr float kNear = 0.02F;
/// Larger sprites are not drawn: the camera is inside of them.
inline constexpr float kLargestRadius = 16384.0F;
/// Sprites with a smaller radius in pixels show one grey of the texture instead of a picture; where texture and shading are
/// weaker, larger ones too: half the contrast needs twice the size to be seen.
inline constexpr float kPlainRadius = 5.0F;

} // namespace fumage
#endif

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;

HWY_INLINE V dotAxis(D d, V x, V y, V z, const glm::vec3& axis)
{
    return hn::Add(hn::Add(hn::Mul(x, hn::Set(d, axis.x)), hn::Mul(y, hn::Set(d, axis.y))), hn::Mul(z, hn::Set(d, axis.z)));
}

void projectBlock(const SpriteJob& job, std::size_t begin, SpriteBlock& block)
{
    const D d;
    const hn::RebindToSigned<D> di;
    const hn::RebindToUnsigned<D> du;
    const Particles& particles = *job.particles;
    const View& view = job.view;
    const GridShape& grid = job.light->shape;
    const V one = hn::Set(d, 1.0F);
    const V focal = hn::Set(d, view.focal);
    for (std::size_t i = 0; i < SpriteBlock::kSize; i += hn::Lanes(d)) {
        const std::size_t at = begin + i;
        const auto key = hn::Load(du, particles.key.data() + at);
        const V px = hn::Load(d, particles.x.data() + at);
        const V py = hn::Load(d, particles.y.data() + at);
        const V pz = hn::Load(d, particles.z.data() + at);
        const V wx = hn::Sub(px, hn::Set(d, view.eye.x));
        const V wy = hn::Sub(py, hn::Set(d, view.eye.y));
        const V wz = hn::Sub(pz, hn::Set(d, view.eye.z));
        const V depth = dotAxis(d, wx, wy, wz, view.forward);
        const V perMetre = hn::Div(focal, hn::Max(depth, hn::Set(d, kNear)));
        const V sx = mulAdd(dotAxis(d, wx, wy, wz, view.right), perMetre, hn::Set(d, 0.5F * static_cast<float>(view.width)));
        const V sy = hn::Sub(hn::Set(d, 0.5F * static_cast<float>(view.height)), hn::Mul(dotAxis(d, wx, wy, wz, view.up), perMetre));
        hn::Store(sx, d, block.x + i);
        hn::Store(sy, d, block.y + i);
        hn::Store(depth, d, block.depth + i);
        hn::Store(hn::Mul(hn::Load(d, job.appearance->radius.data() + at), perMetre), d, block.radius + i);

        const V age = hn::Mul(hn::ConvertTo(d, hn::Sub(hn::Set(di, job.step), hn::Load(di, particles.birthStep.data() + at))), hn::Set(d, job.dt));
        const V turned = hn::Mul(mulAdd(hn::Set(d, 2.0F), unitStream(d, key, kRotationStream), hn::Set(d, -1.0F)), hn::Set(d, job.rotationVariance));
        const V spun = mulAdd(mulAdd(hn::Set(d, 2.0F), unitStream(d, key, kSpinStream), hn::Set(d, -1.0F)), hn::Set(d, job.spinVariance), hn::Set(d, job.spin));
        // Turns of hours leave the range of the sine; the rest of a division by a full turn brings them back.
        V angle = mulAdd(spun, age, turned);
        if (particles.rolls()) {
            // The part of the turn about the line of sight; y runs down on the screen.
            const V about = dotAxis(d, hn::Load(d, particles.rollX.data() + at), hn::Load(d, particles.rollY.data() + at), hn::Load(d, particles.rollZ.data() + at), view.forward);
            angle = mulAdd(about, hn::Set(d, job.roll), angle);
        }
        const V turns = hn::Round(hn::Mul(angle, hn::Set(d, 1.0F / kTau)));
        const SineCosine<V> turn = sinCos(d, angle - turns * kTau);
        hn::Store(turn.sine, d, block.sine + i);
        hn::Store(turn.cosine, d, block.cosine + i);

        const V slices = hn::Set(d, static_cast<float>(job.texture->slices()));
        const V moved = mulAdd(age, hn::Set(d, job.textureSlicesPerSecond / static_cast<float>(job.texture->slices())), unitStream(d, key, kSliceStream));
        hn::Store(hn::Mul(hn::Sub(moved, hn::Floor(moved)), slices), d, block.slice + i);
        if (job.glows) {
            const V variance = hn::Sub(one, hn::Mul(hn::Set(d, job.heatVariance), unitStream(d, key, kHeatStream)));
            hn::Store(hn::Mul(variance, exponential(d, hn::Mul(hn::Set(d, -job.emissionCooling), age))), d, block.heat + i);
        }
        if (job.stretch > 0.0F) {
            const V vx = hn::Load(d, particles.vx.data() + at);
            const V vy = hn::Load(d, particles.vy.data() + at);
            const V vz = hn::Load(d, particles.vz.data() + at);
            hn::Store(hn::Mul(dotAxis(d, vx, vy, vz, view.right), perMetre), d, block.stretchX + i);
            hn::Store(hn::Neg(hn::Mul(dotAxis(d, vx, vy, vz, view.up), perMetre)), d, block.stretchY + i);
        }

        const V perCell = hn::Set(d, 1.0F / grid.cell);
        const auto coordinate = [&](const glm::vec3& axis, float origin, int count, float* fraction) {
            const V cells = hn::Mul(hn::Sub(dotAxis(d, px, py, pz, axis), hn::Set(d, origin)), perCell);
            const V inside = hn::Min(hn::Max(cells, hn::Zero(d)), hn::Set(d, std::max(0.0F, static_cast<float>(count) - 1.001F)));
            const V whole = hn::Floor(inside);
            hn::Store(hn::Sub(inside, whole), d, fraction + i);
            return hn::ConvertTo(di, whole);
        };
        const auto iu = coordinate(grid.axes.u, grid.origin.x, grid.nu, block.fu);
        const auto iv = coordinate(grid.axes.v, grid.origin.y, grid.nv, block.fv);
        const auto iw = coordinate(grid.axes.w, grid.origin.z, grid.nw, block.fw);
        const auto row = hn::Add(hn::Mul(iw, hn::Set(di, grid.nv)), iv);
        hn::Store(hn::Add(hn::Mul(row, hn::Set(di, grid.nu)), iu), di, block.corner + i);
    }
}

HWY_INLINE Float4 load4(const float* from)
{
    Float4 out;
    std::memcpy(&out, from, sizeof(out));
    return out;
}

HWY_INLINE Float4 mix4(Float4 a, Float4 b, float t)
{
    return (b - a) * t + a;
}

/// Trilinear interpolation of the four light channels.
HWY_INLINE Float4 lightAt(const LightGrid& grid, const SpriteBlock& block, std::size_t i)
{
    const std::size_t du = grid.shape.nu > 1 ? 4 : 0;
    const std::size_t dv = grid.shape.nv > 1 ? static_cast<std::size_t>(grid.shape.nu) * 4 : 0;
    const std::size_t dw = grid.shape.nw > 1 ? static_cast<std::size_t>(grid.shape.nu) * static_cast<std::size_t>(grid.shape.nv) * 4 : 0;
    const float* at = grid.light.data() + static_cast<std::size_t>(block.corner[i]) * 4;
    const float u = block.fu[i];
    const auto line = [&](const float* from) { return mix4(load4(from), load4(from + du), u); };
    const Float4 front = mix4(line(at), line(at + dv), block.fv[i]);
    const Float4 back = mix4(line(at + dw), line(at + dw + dv), block.fv[i]);
    return mix4(front, back, block.fw[i]);
}

/// Matrix and box of a sprite: rotated, and where asked for stretched along its motion with its area kept.
HWY_INLINE void shapeSprite(const SpriteJob& job, const SpriteBlock& block, std::size_t i, float radius, Sprite& sprite)
{
    const float s = block.sine[i] / radius;
    const float c = block.cosine[i] / radius;
    sprite.m00 = c;
    sprite.m01 = s;
    sprite.m10 = -s;
    sprite.m11 = c;
    if (job.stretch <= 0.0F && !job.style.square) {
        sprite.halfWidth = radius;
        sprite.halfHeight = radius;
        return;
    }
    if (job.stretch > 0.0F) {
        const float vx = block.stretchX[i];
        const float vy = block.stretchY[i];
        const float speed = std::sqrt(vx * vx + vy * vy);
        constexpr float kMostStretch = 8.0F;
        const float longer = std::min(kMostStretch, std::sqrt(1.0F + speed * job.stretch / radius));
        if (speed > 1e-6F) {
            // M becomes M (longer^-1 along the motion, longer across it).
            const float ex = vx / speed;
            const float ey = vy / speed;
            const float along = 1.0F / longer;
            const float xx = ex * ex * along + ey * ey * longer;
            const float yy = ey * ey * along + ex * ex * longer;
            const float xy = ex * ey * (along - longer);
            sprite.m00 = c * xx + s * xy;
            sprite.m01 = c * xy + s * yy;
            sprite.m10 = c * xy - s * xx;
            sprite.m11 = c * yy - s * xy;
        }
    }
    // Box of the unit circle under M^-1: half extents are the lengths of its rows; of the square, the sums of magnitudes.
    const float determinant = sprite.m00 * sprite.m11 - sprite.m01 * sprite.m10;
    const float inverse = 1.0F / determinant;
    const float i00 = sprite.m11 * inverse;
    const float i01 = -sprite.m01 * inverse;
    const float i10 = -sprite.m10 * inverse;
    const float i11 = sprite.m00 * inverse;
    if (job.style.square) {
        sprite.halfWidth = std::abs(i00) + std::abs(i01);
        sprite.halfHeight = std::abs(i10) + std::abs(i11);
    } else {
        sprite.halfWidth = std::sqrt(i00 * i00 + i01 * i01);
        sprite.halfHeight = std::sqrt(i10 * i10 + i11 * i11);
    }
}

/// The level whose texels are about a pixel large.
HWY_INLINE int textureLevel(const SpriteJob& job, float radius)
{
    const float texelsAPixel = job.style.textureScale * static_cast<float>(job.texture->size()) / (2.0F * radius);
    int level = 0;
    constexpr float kTexelsAPixel = 1.5F;
    for (float rest = texelsAPixel; rest > kTexelsAPixel && level + 1 < job.texture->levels(); rest *= 0.5F) {
        ++level;
    }
    return level;
}

/// Chooses slice, offset and resolution; a sprite too small for a texture takes one grey of the coarsest level into its opacity.
HWY_INLINE void textureSprite(const SpriteJob& job, const SpriteBlock& block, std::size_t i, std::uint32_t key, float life, float radius, Sprite& sprite)
{
    const std::uint32_t offset = mixBits(key ^ 0x51ed270bU);
    const auto slice = static_cast<std::uint32_t>(std::min(block.slice[i], static_cast<float>(job.texture->slices() - 1)));
    const float threshold = job.erosion * life;
    if (radius * job.contrast >= kPlainRadius || job.style.square) {
        sprite.texture = packTexture(slice, static_cast<std::uint32_t>(textureLevel(job, radius)), offset & 255U, offset >> 8U & 255U, static_cast<std::uint32_t>(threshold * static_cast<float>(TextureRef::kErosionSteps) + 0.5F));
        return;
    }
    const int coarsest = job.texture->levels() - 1;
    const std::uint32_t texel = job.texture->texels(coarsest, static_cast<int>(slice))[offset >> 16U & (SpriteTexture::kSmallest * SpriteTexture::kSmallest - 1U)];
    const float grey = static_cast<float>(texel & 255U) / 255.0F;
    const float kept = std::clamp((grey - threshold) / job.style.erosionSoftness, 0.0F, 1.0F);
    sprite.opacity *= 1.0F - job.style.texture + job.style.texture * kept;
    sprite.texture = packTexture(0, TextureRef::kPlain, 0, 0, 0);
}

HWY_INLINE void lightSprite(const SpriteJob& job, const SpriteBlock& block, std::size_t i, float life, Sprite& sprite)
{
    const Float4 light = lightAt(*job.light, block, i);
    const Float4 albedo = job.albedo[static_cast<std::size_t>(life * static_cast<float>(kColourTableSize - 1))];
    const Float4 direct = albedo * job.sun * light[0];
    Float4 ambient = albedo * (job.sky * light[1] + job.ground * light[2]);
    if (job.glows) {
        // Sky and ground together tell how open a place is.
        const float open = std::min(1.0F, light[1] + light[2]);
        const float heat = std::clamp(block.heat[i] * (1.0F - job.hotCore * open), 0.0F, 1.0F);
        ambient += job.emission[static_cast<std::size_t>(heat * static_cast<float>(kColourTableSize - 1))];
    }
    // The fourth lanes fall on the opacity and the texture, which are written after this.
    static_assert(offsetof(Sprite, opacity) == offsetof(Sprite, direct) + 12 && offsetof(Sprite, texture) == offsetof(Sprite, ambient) + 12);
    std::memcpy(reinterpret_cast<char*>(&sprite) + offsetof(Sprite, direct), &direct, sizeof(direct));
    std::memcpy(reinterpret_cast<char*>(&sprite) + offsetof(Sprite, ambient), &ambient, sizeof(ambient));
}

void spriteBlock(const SpriteJob& job, std::size_t begin)
{
    SpriteBlock block;
    projectBlock(job, begin, block);
    for (std::size_t i = 0; i < SpriteBlock::kSize; ++i) {
        const std::size_t at = begin + i;
        const float exact = block.radius[i];
        const bool visible = exact > 0.0F && exact < kLargestRadius && block.depth[i] > kNear && std::abs(block.x[i]) < 1e6F && std::abs(block.y[i]) < 1e6F;
        job.out->depth[at] = SpriteBatch::kHidden;
        job.out->boxes[at] = {};
        if (!visible) {
            continue;
        }
        Sprite& sprite = job.out->sprites[at];
        const float life = job.appearance->life[at];
        const float radius = std::max(exact, kSmallestRadius);
        const float thinner = exact / radius;
        lightSprite(job, block, i, life, sprite);
        sprite.x = block.x[i];
        sprite.y = block.y[i];
        sprite.opacity = job.appearance->alpha[at] * (thinner * thinner);
        shapeSprite(job, block, i, radius, sprite);
        textureSprite(job, block, i, job.particles->key[at], life, radius, sprite);
        job.out->boxes[at] = boxOf(sprite, job.view.width, job.view.height);
        // Positive floats sort as their bits do.
        job.out->depth[at] = std::bit_cast<std::uint32_t>(block.depth[i]) >> (31U - SpriteBatch::kDepthBits);
    }
}

} // namespace fumage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumage {

HWY_EXPORT(spriteBlock);

namespace {

Float4 colour4(const glm::vec3& colour)
{
    return Float4{colour.r, colour.g, colour.b, 0.0F};
}

SpriteStyle makeStyle(const Effect& effect, const View& view)
{
    const Look& look = effect.look;
    SpriteStyle style;
    style.square = look.mask == MaskShape::Square;
    style.hardness = maskHardness(look);
    style.texture = look.texture;
    style.erosionSoftness = look.erosionSoftness;
    style.textureScale = look.textureScale;
    style.lightX = glm::dot(effect.light.direction, view.right);
    style.lightY = -glm::dot(effect.light.direction, view.up);
    style.relief = look.relief;
    style.roundness = look.roundness;
    return style;
}

/// The glow of a share of the heat at birth.
glm::vec3 glowAt(const Light& light, const BlackBody& body, float share)
{
    return light.emissionColour == EmissionColour::BlackBody ? body.at(light.temperature * share) : light.emissionGradient.at(share);
}

void fillTables(const Effect& effect, SpriteJob& job)
{
    const BlackBody body(effect.light.temperature);
    job.glows = effect.light.emission > 0.0F;
    for (std::size_t i = 0; i < kColourTableSize; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(kColourTableSize - 1);
        job.albedo[i] = colour4(effect.look.colour * effect.look.colourGradient.at(share));
        if (job.glows) {
            job.emission[i] = colour4(glowAt(effect.light, body, share) * effect.light.emission);
        }
    }
    job.sun = colour4(effect.light.colour);
    job.sky = colour4(effect.light.sky * effect.light.ambient);
    job.ground = colour4(effect.light.ground * effect.light.ambient);
}

} // namespace

void makeSprites(const Frame& frame, const SampledEffect& effect, const Appearance& appearance, const LightGrid& light, const SpriteTexture& texture,
    const View& view, SpriteBatch& out)
{
    SpriteJob job;
    job.particles = &frame.particles;
    job.appearance = &appearance;
    job.light = &light;
    job.texture = &texture;
    job.out = &out;
    job.view = view;
    job.step = static_cast<std::int32_t>(frame.step);
    job.dt = frame.model->schedule().dt;
    job.rotationVariance = kPi * effect->look.rotationVariance;
    job.spin = radians(effect->look.spin);
    job.roll = effect->look.roll;
    job.spinVariance = radians(effect->look.spinVariance);
    job.textureSlicesPerSecond = effect->look.textureRate * static_cast<float>(texture.slices()) / effect->noise.depth;
    job.emissionCooling = effect->light.emissionCooling;
    job.hotCore = effect->light.hotCore;
    job.heatVariance = effect->motion.heatVariance;
    job.erosion = effect->look.erosion;
    job.stretch = effect->look.stretch;
    job.style = makeStyle(effect, view);
    job.contrast = std::min(1.0F, std::max({job.style.texture, job.style.relief, job.style.roundness}));
    fillTables(effect, job);

    const std::size_t padded = frame.particles.x.size();
    out.sprites.resize(padded);
    out.boxes.resize(padded);
    out.depth.resize(padded);
    out.style = job.style;
    out.view = view;
    parallelFor(frame.particles.chunks(), [&](std::size_t chunk) {
        for (std::size_t block = 0; block < Particles::kChunk; block += SpriteBlock::kSize) {
            HWY_DYNAMIC_DISPATCH(spriteBlock)
            (job, chunk * Particles::kChunk + block);
        }
    });
}

} // namespace fumage
#endif
