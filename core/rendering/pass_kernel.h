#pragma once

#include "core/lighting/six_way.h"
#include "core/rendering/sprites.h"

namespace fumage {

/// Particles of another moment, seen by the camera as it is then.
struct OtherMoment {
    const Particles* particles = nullptr; ///< null: there is none
    View view;
    std::int32_t laps = 0; ///< steps by which its births are numbered higher: those of a loop
};

/// What the layers of one frame are made of; a layer that is null is left out.
struct PassJob {
    const Particles* particles = nullptr;
    const SpriteBatch* batch = nullptr; ///< of the same particles
    View view;

    const SixWayLight* sixWay = nullptr;
    SpriteLayer* above = nullptr;
    SpriteLayer* below = nullptr;

    OtherMoment previous;
    OtherMoment next;
    float seconds = 0.0F; ///< to the next moment
    SpriteLayer* motion = nullptr;

    const LightGrid* light = nullptr;
    SpriteLayer* inner = nullptr; ///< gets the shadow in its second channel
};

/// Fills the layers for particles [begin, begin + kSpriteBlock).
/// @param begin a multiple of kSpriteBlock
void makePassBlock(const PassJob& job, std::size_t begin);

} // namespace fumage
