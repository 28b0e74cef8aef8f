#pragma once

#include "core/lighting/detail_field.h"
#include "core/rendering/sprite_batch.h"
#include "core/rendering/sprite_job.h"
#include "core/simulation/particles.h"

namespace fumage {

/// What the sprites of a batch read of the detail.
struct SpriteDetailJob {
    const DetailField* detail = nullptr;
    const Particles* particles = nullptr;
    glm::vec3 lightDirection{0.0F, -1.0F, 0.0F}; ///< that the light travels
    SpriteBatch* batch = nullptr; ///< whose sprites are made
};

/// Finds where some sprites read the noise that their air carries.
/// @param begin the first of kSpriteBlock sprites
void findSpriteDetail(const SpriteDetailJob& job, const SpriteSurroundings& surroundings, std::size_t begin);

} // namespace fumage
