#pragma once

#include "core/base/result.h"
#include "core/effect/effect.h"

#include <glm/vec3.hpp>

namespace fumage {

/// Where the emitter is and how it moves.
struct EmitterPose {
    glm::vec3 position{0.0F}; ///< m
    glm::vec3 normal{0.0F, 1.0F, 0.0F}; ///< of any length but 0
    glm::vec3 velocity{0.0F}; ///< that particles take along at birth, m/s of the game; (0, 0, 0) where smoke shall not
                              ///< be thrown by a moving emitter
};

/// Where an effect has its emitter, at rest.
[[nodiscard]] EmitterPose poseOf(const Emitter& emitter);

/// The pose with its normal made a unit.
/// @error OutOfRange where it has no direction or is no number
[[nodiscard]] Result<EmitterPose> checkedPose(const EmitterPose& pose);

/// A pose on the way from one to another, straight, the normal turning with it; a turn to almost the opposite has
/// happened at once.
/// @param share 0 to 1; 1 is the other, to the bit
[[nodiscard]] EmitterPose between(const EmitterPose& from, const EmitterPose& to, double share);

/// Where a pose goes that is fixed to another one, when that goes from one place to another: as a part of the same
/// body, which is turned by the shortest way that takes its normal to the new one, or half around where they are
/// opposite.
/// @param from,to with unit normals
/// @return with the velocity of to
[[nodiscard]] EmitterPose carriedAlong(const EmitterPose& own, const EmitterPose& from, const EmitterPose& to);

} // namespace fumage
