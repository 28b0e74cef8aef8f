#pragma once

#include "core/rendering/sprite_job.h"

#include <cstddef>

namespace fumage {

/// Makes the sprites, boxes and depths of particles [begin, begin + kSpriteBlock).
/// @param begin a multiple of kSpriteBlock
void makeSpriteBlock(const SpriteJob& job, std::size_t begin, SpriteSurroundings* surroundings);

} // namespace fumage
