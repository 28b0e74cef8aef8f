#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/rendering/sprite_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "core/rendering/sprite_kernel.h"
#include "core/rendering/sprite_projection-inl.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace fumage::HWY_NAMESPACE {

/// A particle smaller than this is drawn this large and thinner, so that it does not flicker between pixels.
constexpr float kSmallestRadius = 1.0F;
/// Larger sprites are not drawn: the camera is inside of them.
constexpr float kLargestRadius = 16384.0F;
/// Sprites with a smaller radius in pixels show one grey of the texture instead of a picture; where texture and shading
/// are weaker, larger ones too: half the contrast needs twice the size to be seen.
constexpr float kPlainRadius = 5.0F;

/// Multiplies a sprite's matrix by a symmetric one from the right.
HWY_INLINE void multiply(float xx, float xy, float yy, Sprite& sprite)
{
    const float a = sprite.m00;
    const float b = sprite.m01;
    const float c = sprite.m10;
    const float e = sprite.m11;
    sprite.m00 = a * xx + b * xy;
    sprite.m01 = a * xy + b * yy;
    sprite.m10 = c * xx + e * xy;
    sprite.m11 = c * xy + e * yy;
}

/// Stretches a sprite along its motion, with its area kept: M becomes M (longer^-1 along the motion, longer across it).
HWY_INLINE void stretchSprite(
    const SpriteJob& job, const SpriteBlock& block, std::size_t i, float radius, Sprite& sprite)
{
    const float vx = block.stretchX[i];
    const float vy = block.stretchY[i];
    const float speed = std::sqrt(vx * vx + vy * vy);
    constexpr float kStill = 1e-6F; // pixels/s
    if (!(speed > kStill)) {
        return;
    }
    constexpr float kMaxStretch = 8.0F;
    const float longer = std::min(kMaxStretch, std::sqrt(1.0F + speed * job.stretch / radius));
    const float along = 1.0F / longer;
    const float ex = vx / speed;
    const float ey = vy / speed;
    const float xx = ex * ex * along + ey * ey * longer;
    const float yy = ey * ey * along + ex * ex * longer;
    const float xy = ex * ey * (along - longer);
    multiply(xx, xy, yy, sprite);
}

/// Box of the unit circle under M^-1: half extents are the lengths of its rows; of the square, the sums of magnitudes,
/// and the soft edge.
HWY_INLINE void boundSprite(bool square, Sprite& sprite)
{
    const float inverse = 1.0F / (sprite.m00 * sprite.m11 - sprite.m01 * sprite.m10);
    const float i00 = sprite.m11 * inverse;
    const float i01 = -sprite.m01 * inverse;
    const float i10 = -sprite.m10 * inverse;
    const float i11 = sprite.m00 * inverse;
    if (square) {
        sprite.halfWidth = std::abs(i00) + std::abs(i01) + kHalfEdge;
        sprite.halfHeight = std::abs(i10) + std::abs(i11) + kHalfEdge;
    } else {
        sprite.halfWidth = std::sqrt(i00 * i00 + i01 * i01);
        sprite.halfHeight = std::sqrt(i10 * i10 + i11 * i11);
    }
}

/// Matrix and box of a sprite: rotated, and where asked for stretched.
HWY_INLINE void shapeSprite(const SpriteJob& job, const SpriteBlock& block, std::size_t i, float radius, Sprite& sprite)
{
    const float s = block.sine[i] / radius;
    const float c = block.cosine[i] / radius;
    sprite.m00 = c;
    sprite.m01 = s;
    sprite.m10 = -s;
    sprite.m11 = c;
    if (job.stretch <= 0.0F && !job.deforms && !job.style.square) {
        sprite.halfWidth = radius;
        sprite.halfHeight = radius;
        return;
    }
    if (job.deforms) {
        multiply(block.shapeXX[i], block.shapeXY[i], block.shapeYY[i], sprite);
    }
    if (job.stretch > 0.0F) {
        stretchSprite(job, block, i, radius, sprite);
    }
    boundSprite(job.style.square, sprite);
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

/// The same of a picture, of which sprites show no part nor slice.
HWY_INLINE std::uint32_t pictureLevel(const SpriteJob& job, float radius)
{
    constexpr float kTexelsAPixel = 1.5F;
    std::uint32_t level = 0;
    for (float rest = job.style.pictureReach / radius;
         rest > kTexelsAPixel && static_cast<int>(level) + 1 < job.picture->levels(); rest *= 0.5F) {
        ++level;
    }
    return level;
}

/// Chooses slice, offset and resolution; a sprite too small for a texture takes one grey of the coarsest level into its
/// opacity.
HWY_INLINE void textureSprite(const SpriteJob& job, const SpriteBlock& block, std::size_t i, std::uint32_t key,
    float life, float radius, Sprite& sprite)
{
    if (job.picture != nullptr) {
        sprite.texture = packTexture(0, pictureLevel(job, radius), 0, 0, 0);
        return;
    }
    const std::uint32_t offset = mixBits(key ^ 0x51ed270bU);
    const auto slice =
        static_cast<std::uint32_t>(std::min(block.slice[i], static_cast<float>(job.texture->slices() - 1)));
    const float threshold = job.erosion * life;
    const auto erosion = static_cast<std::uint32_t>(threshold * static_cast<float>(TextureRef::kErosionSteps) + 0.5F);
    const auto makeEven = [&](int level) {
        if (job.style.texture > 0.0F) {
            sprite.opacity = std::min(1.0F, sprite.opacity * job.evenness[static_cast<std::size_t>(level)][erosion]);
        }
    };
    if (radius * job.contrast >= kPlainRadius || job.style.square) {
        const int level = textureLevel(job, radius);
        makeEven(level);
        sprite.texture =
            packTexture(slice, static_cast<std::uint32_t>(level), offset & 255U, offset >> 8U & 255U, erosion);
        return;
    }
    makeEven(job.texture->levels());
    const int coarsest = job.texture->levels() - 1;
    const std::uint32_t texel = job.texture->texels(
        coarsest, static_cast<int>(slice))[offset >> 16U & (SpriteTexture::kSmallest * SpriteTexture::kSmallest - 1U)];
    const float grey = static_cast<float>(texel & 255U) / 255.0F;
    const float kept = std::clamp((grey - threshold) / job.style.erosionSoftness, 0.0F, 1.0F);
    sprite.opacity *= 1.0F - job.style.texture + job.style.texture * kept;
    sprite.texture = packTexture(0, TextureRef::kPlain, 0, 0, 0);
}

/// @return its glow, of which red has all that there is
HWY_INLINE float lightSprite(const SpriteJob& job, const SpriteBlock& block, std::size_t i, float life, Sprite& sprite)
{
    const LitColour colour = litColourOf(job.colours, *job.light, block.lit, i, life);
    std::memcpy(sprite.direct, &colour.direct, sizeof(sprite.direct));
    std::memcpy(sprite.ambient, &colour.ambient, sizeof(sprite.ambient));
    return colour.glow;
}

HWY_INLINE void lookAround(const SpriteJob& job, const SpriteBlock& block, std::size_t i, const Sprite& sprite,
    float glow, SpriteSurroundings& out)
{
    constexpr float kNone = 1e-12F;
    out.glowing[i] = glow / std::max(sprite.ambient[0], kNone);
    out.body[i] = block.lit.at<float>(job.light->shape, *job.body, i);
}

void spriteBlock(const SpriteJob& job, std::size_t begin, SpriteSurroundings* surroundings)
{
    SpriteBlock block;
    projectBlock(job, begin, block);
    for (std::size_t i = 0; i < kSpriteBlock; ++i) {
        const std::size_t at = begin + i;
        const float exact = block.radius[i];
        const bool visible = exact > 0.0F && exact < kLargestRadius && block.depth[i] > kNear
            && std::abs(block.x[i]) < 1e6F && std::abs(block.y[i]) < 1e6F;
        job.out->depth[at] = SpriteBatch::kHidden;
        job.out->boxes[at] = {};
        if (!visible) {
            continue;
        }
        Sprite& sprite = job.out->sprites[at];
        const float life = job.appearance->life[at];
        const float radius = std::max(exact, kSmallestRadius);
        const float thinner = exact / radius;
        const float glow = lightSprite(job, block, i, life, sprite);
        if (surroundings != nullptr) {
            surroundings->radius[i] = radius;
            lookAround(job, block, i, sprite, glow, *surroundings);
        }
        sprite.x = block.x[i];
        sprite.y = block.y[i];
        sprite.opacity = job.appearance->alpha[at] * (thinner * thinner);
        if (job.deforms) {
            sprite.opacity = std::min(1.0F, sprite.opacity / block.area[i]);
        }
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

void makeSpriteBlock(const SpriteJob& job, std::size_t begin, SpriteSurroundings* surroundings)
{
    const auto kernel = HWY_DYNAMIC_DISPATCH(spriteBlock);
    kernel(job, begin, surroundings);
}

} // namespace fumage
#endif
