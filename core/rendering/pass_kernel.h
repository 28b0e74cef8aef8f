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

/// What the targets of one frame are made of; a target that is null is left out.
struct PassJob {
    const Particles* particles = nullptr;
    const SpriteBatch* batch = nullptr; ///< of the same particles
    View view;

    const SixWayLight* sixWay = nullptr;
    SpriteTarget* above = nullptr;
    SpriteTarget* below = nullptr;

    OtherMoment previous;
    OtherMoment next;
    float seconds = 0.0F; ///< to the next moment
    SpriteTarget* motion = nullptr;

    const LightGrid* light = nullptr;
    SpriteTarget* inner = nullptr; ///< gets the shadow in its second channel
};

/// Fills the targets for particles [begin, begin + kSpriteBlock).
/// @param begin a multiple of kSpriteBlock
void makePassBlock(const PassJob& job, std::size_t begin);

} // namespace fumage
