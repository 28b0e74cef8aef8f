#pragma once

#include "core/base/aligned_array.h"
#include "core/noise/detail_texture.h"
#include "core/rendering/camera.h"
#include "core/rendering/sprite_picture.h"
#include "core/rendering/sprite_texture.h"
#include "core/simulation/particles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>

namespace fumage {

/// One particle on the screen: an ellipse or square with its light; a cache line long.
///
/// A pixel at (dx, dy) from the centre lies at (p, q) = (m00 dx + m01 dy, m10 dx + m11 dy) in the sprite, whose rim is
/// p^2 + q^2 = 1 (disc) or max(|p|, |q|) = 1 (square).
struct alignas(64) Sprite {
    float x = 0.0F; ///< centre, pixels from the left
    float y = 0.0F; ///< pixels from the top
    float halfWidth = 0.0F; ///< of the box around it, pixels; 0: not visible
    float halfHeight = 0.0F;
    float m00 = 0.0F, m01 = 0.0F, m10 = 0.0F, m11 = 0.0F;
    float direct[3] = {}; ///< colour of what the sun gives, linear
    float opacity = 0.0F; ///< at the centre, in [0, 1]; for a plain sprite with the texture in it
    float ambient[3] = {}; ///< colour of everything else
    std::uint32_t texture = 0; ///< see packTexture()
};

/// Pixels that the edge of a square, which is one wide, reaches beyond the square.
inline constexpr float kHalfEdge = 0.5F;

/// Where a textured sprite reads the noise, in 32 bits.
struct TextureRef {
    static constexpr unsigned kSliceBits = 7;
    static constexpr unsigned kLevelBits = 4;
    static constexpr unsigned kOffsetBits = 8;
    static constexpr std::uint32_t kErosionSteps = 31; ///< in the 5 bits that are left

    static constexpr int kPlain = (1 << kLevelBits) - 1;

    int slice = 0; ///< below kMaxNoiseSlices
    int level = kPlain; ///< resolution; kPlain: the sprite is too small to show a texture
    std::uint32_t u = 0; ///< offset into the tile, in 1/256 of it
    std::uint32_t v = 0;
    float erosion = 0.0F; ///< the noise below this is gone, in 1/kErosionSteps
};
static_assert(kMaxNoiseSlices <= 1 << TextureRef::kSliceBits);
static_assert(SpriteTexture::kMaxLevels <= TextureRef::kPlain);

/// @param slice 0 to 127
/// @param level 0 to 15, see TextureRef::kPlain
/// @param u,v in 1/256 of a tile, taken modulo 256
/// @param erosion 0 to 31
[[nodiscard]] constexpr std::uint32_t packTexture(
    std::uint32_t slice, std::uint32_t level, std::uint32_t u, std::uint32_t v, std::uint32_t erosion)
{
    using T = TextureRef;
    constexpr std::uint32_t kOffset = (1U << T::kOffsetBits) - 1U;
    return slice
        | (level | ((u & kOffset) | ((v & kOffset) | erosion << T::kOffsetBits) << T::kOffsetBits) << T::kLevelBits)
        << T::kSliceBits;
}
/// What packTexture() was given.
[[nodiscard]] constexpr TextureRef unpackTexture(std::uint32_t bits)
{
    const auto take = [&bits](unsigned count) {
        const std::uint32_t field = bits & ((1U << count) - 1U);
        bits >>= count;
        return field;
    };
    TextureRef ref;
    ref.slice = static_cast<int>(take(TextureRef::kSliceBits));
    ref.level = static_cast<int>(take(TextureRef::kLevelBits));
    ref.u = take(TextureRef::kOffsetBits);
    ref.v = take(TextureRef::kOffsetBits);
    ref.erosion = static_cast<float>(bits) / static_cast<float>(TextureRef::kErosionSteps);
    return ref;
}

/// A way through the texels of the detail as three bytes, for relief.
struct LightBytes {
    static constexpr int kLongest = 63; ///< of a component

    /// What was packed, from -kLongest to kLongest.
    [[nodiscard]] static glm::vec3 unpacked(std::uint32_t bytes)
    {
        const auto byte = [&](unsigned which) {
            return static_cast<float>(static_cast<std::int8_t>(bytes >> 8U * which & 255U));
        };
        return {byte(1), byte(2), byte(3)};
    }

    std::uint32_t packed = 0; ///< from the second byte on: x, y, z, signed
    float scale = 0.0F; ///< what one is worth, texels

    LightBytes(float x, float y, float z)
    {
        const float longest = std::max({std::abs(x), std::abs(y), std::abs(z)});
        constexpr float kNone = 1e-20F;
        scale = longest / static_cast<float>(kLongest);
        const float perUnit = static_cast<float>(kLongest) / std::max(longest, kNone);
        const auto byte = [&](float component) {
            // Counted from 0 on: what is cut off then is the same for both signs.
            const int counted = static_cast<int>(component * perUnit + static_cast<float>(kLongest) + 0.5F);
            return static_cast<std::uint32_t>(counted - kLongest) & 255U;
        };
        packed = byte(x) << 8U | byte(y) << 16U | byte(z) << 24U;
    }
};

/// Where a sprite reads the noise that its air carries, see DetailTexture; two cache lines long. The noise is linear
/// about the particle: at (dx, dy) pixels from the centre it is read at `at + u dx + v dy`.
struct alignas(64) SpriteDetail {
    /// One of the two maps of coordinates; all in texels of a level.
    struct Phase {
        std::array<float, 3> at{}; ///< at the centre, 0 to the size of the level
        std::array<float, 3> u{}; ///< a pixel to the right
        std::array<float, 3> v{}; ///< a pixel down
        std::uint32_t light = 0; ///< LightBytes of the way that light takes from where relief looks
        float relief = 0.0F; ///< what the slope along that way is worth
        float weight = 0.0F;
    };
    std::array<Phase, 2> phases;
    float strength = 0.0F; ///< alpha is multiplied by 1 + strength * noise, bent so that it stays above 0
    float perMean = 1.0F; ///< over the mean of that
    float gain = 1.0F, flat = 2.0F, bend = 0.0F; ///< of a PhaseBlend; where one phase is shown, its gain alone
    float screenRelief = 0.0F; ///< what a slope a pixel is worth for lights from the sides of the picture
    float around = 0.0F; ///< what does not come from the sun is multiplied by 1 + around * noise
    std::array<std::uint8_t, 2> levels{};
    std::array<std::uint8_t, 2> shown{}; ///< whether each phase is; they stand last
};
static_assert(sizeof(SpriteDetail) == 128);

/// What all sprites of a frame share.
struct SpriteStyle {
    bool square = false;
    float hardness = 1.0F; ///< 1 / softness
    float texture = 0.0F; ///< how much the noise disturbs the alpha
    float erosionSoftness = 1.0F;
    float textureScale = 1.0F; ///< tiles across the sprite
    float lightX = 0.0F; ///< way of the light on the screen, y down, length up to 1
    float lightY = 0.0F;
    float relief = 0.0F;
    float roundness = 0.0F;
    float pictureReach = 0.0F; ///< half the edge of a picture on a square, texels of its finest level; 0: none
};

/// Pixels of the picture that a sprite may touch, inclusive: an eighth of the sprite's memory, which is all that
/// binning reads.
struct SpriteBox {
    std::uint16_t left = 1, top = 0, right = 0, bottom = 0; ///< left > right: none
};

/// @param width,height of the picture, at most 65535
[[nodiscard]] inline SpriteBox boxOf(const Sprite& sprite, int width, int height)
{
    const float left = sprite.x - sprite.halfWidth;
    const float right = sprite.x + sprite.halfWidth;
    const float top = sprite.y - sprite.halfHeight;
    const float bottom = sprite.y + sprite.halfHeight;
    const auto lastColumn = static_cast<float>(width - 1);
    const auto lastRow = static_cast<float>(height - 1);
    if (!(right > 0.0F && left < lastColumn + 1.0F && bottom > 0.0F && top < lastRow + 1.0F)) {
        return {};
    }
    const auto pixel = [](float at, float last) {
        return static_cast<std::uint16_t>(static_cast<int>(std::min(std::max(at, 0.0F), last)));
    };
    return {pixel(left, lastColumn), pixel(top, lastRow), pixel(right, lastColumn), pixel(bottom, lastRow)};
}

/// Everything that is drawn of a frame. Sprite i belongs to slot i of the particles.
struct SpriteBatch {
    AlignedArray<Sprite> sprites;
    AlignedArray<SpriteDetail> details; ///< of each sprite; empty: the smoke has none that its air carries
    AlignedArray<SpriteBox> boxes;
    AlignedArray<std::uint32_t> depth; ///< sort key: greater is farther; kHidden where nothing is drawn
    SpriteStyle style;
    View view;

    static constexpr std::uint32_t kHidden = 0xffffffffU;
    static constexpr unsigned kDepthBits = 22;

    /// Adds a sprite to a batch made by hand, whose view is set.
    void add(const Sprite& sprite, std::uint32_t at)
    {
        sprites.push_back(sprite);
        boxes.push_back(at == kHidden ? SpriteBox{} : boxOf(sprite, view.width, view.height));
        depth.push_back(at);
    }
};

/// What the sprites of a layer show: noise, or a picture in its place.
struct SpriteSurface {
    std::shared_ptr<const SpriteTexture> texture;
    std::shared_ptr<const SpritePicture> picture; ///< null: none
    friend bool operator==(const SpriteSurface&, const SpriteSurface&) = default;
};

/// A layer of sprites with the noise that they show, or a picture in its place; all outlive it.
struct SpriteLayer {
    const SpriteBatch* batch = nullptr;
    const SpriteTexture* texture = nullptr;
    const SpritePicture* picture = nullptr;
};

/// What is drawn together, by depth: all batches have the same view.
using SpriteLayers = std::span<const SpriteLayer>;

/// Which sprite of which layer, in 32 bits: in the order of layers, and in each in that of its sprites.
struct SpriteNumber {
    static constexpr unsigned kSlotBits = 22;
    static constexpr std::uint32_t kSlots = 1U << kSlotBits;
    static constexpr std::size_t kMaxLayers = std::size_t{1} << (32U - kSlotBits);

    std::uint32_t bits = 0;

    explicit constexpr SpriteNumber(std::uint32_t packed)
        : bits(packed)
    {
    }
    constexpr SpriteNumber(std::size_t layer, std::size_t slot)
        : bits(static_cast<std::uint32_t>(layer << kSlotBits | slot))
    {
    }
    [[nodiscard]] constexpr std::size_t layer() const { return bits >> kSlotBits; }
    [[nodiscard]] constexpr std::size_t slot() const { return bits & (kSlots - 1U); }
};
static_assert(kMaxParticles + Particles::kChunk <= SpriteNumber::kSlots);

/// The lights of a target, one a channel, that shade the noise of sprites.
enum class TargetLight {
    Flat, ///< none: the channels are no light, or come from everywhere
    RightTopBack, ///< from the right of the picture, from its top, from behind
    LeftBottomFront, ///< from the left, from the bottom, from the eye
};

/// Other colours for the sprites of a batch: blended with the same opacities in the same order they make another
/// picture of the same smoke.
struct SpriteTarget {
    static constexpr std::size_t kStride = 4;

    TargetLight light = TargetLight::Flat;
    bool isTinted = false; ///< what sprites with a picture show is multiplied by its colours
    /// kStride floats a sprite: three channels, of any sign, and one that is not looked at
    AlignedArray<float> colours;
};

} // namespace fumage
