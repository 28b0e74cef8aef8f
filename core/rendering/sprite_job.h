#pragma once

#include "core/lighting/particle_light.h"
#include "core/rendering/sprite_batch.h"

#include <array>
#include <cstdint>
#include <vector>

namespace fumage {

/// Constants of one pass over the particles.
struct SpriteJob {
    const Particles* particles = nullptr;
    const Appearance* appearance = nullptr;
    const LightGrid* light = nullptr;
    const AlignedArray<float>* body =
        nullptr; ///< how deep in smoke each cell is, where there is detail; see findBody()
    const SpriteTexture* texture = nullptr;
    const SpritePicture* picture = nullptr; ///< in place of the texture; null: none
    SpriteBatch* out = nullptr;

    View view;
    ParticleLight colours;

    std::int32_t step = 0;
    float dt = 0.0F;
    bool bornBetweenSteps = false;
    float rotationVariance = 0.0F; ///< radians
    float spin = 0.0F; ///< radians/s
    float spinVariance = 0.0F;
    float roll = 0.0F; ///< share of the particle's own turn
    float textureSlicesPerSecond = 0.0F;
    // Of what changes over time: what it has added up to since particles of each whole age in steps were born, see
    // sumOverAges(); empty: it does not change.
    std::vector<float> spun; ///< radians
    std::vector<float> spunVariance; ///< radians
    std::vector<float> boiled; ///< depths of the noise
    float erosion = 0.0F;
    /// What makes a sprite cover as much at each level of its texture, the last that of plain sprites, as it does at
    /// the finest; by erosion.
    std::array<std::array<float, TextureRef::kErosionSteps + 1>, SpriteTexture::kMaxLevels + 1> evenness{};
    float contrast = 1.0F; ///< of texture and shading inside a sprite, up to 1
    float stretch = 0.0F; ///< s of the smoke
    bool deforms = false; ///< particles have a shape that is drawn
    float deformation = 0.0F; ///< share of it that is drawn
    float deformationLimit = 1.0F; ///< of an axis, over the radius
    SpriteStyle style;
};

/// Sprites that are made at a time.
inline constexpr std::size_t kSpriteBlock = kLitBlock;

/// What a block of sprites knows of the smoke about them, for the detail that they show.
struct SpriteSurroundings {
    alignas(kAlignment) std::array<float, kSpriteBlock> body; ///< how deep in smoke, see findBody()
    alignas(kAlignment) std::array<float, kSpriteBlock> radius; ///< pixels
    alignas(kAlignment)
        std::array<float, kSpriteBlock> glowing; ///< share of glow in all light that does not come from the sun
};

} // namespace fumage
