#pragma once

#include "core/effect/track.h"

#include <optional>

namespace fumage {

// What is done to key frames so that the curve stays where it is, but for what was asked.

/// Adds a key frame on the curve, which stays as it is: a smooth piece is divided into two free ones, and smooth keys
/// beside it that would get other slopes become free with those that they had.
///
/// To the bit where the value holds, within the rounding of its numbers else; a linear or held key where a smooth piece
/// ends keeps the slope with which it is arrived at. But of three curves something is lost: a free piece that the hard
/// range cuts off bends on its way there; a direction goes the same way at another pace; a key beyond the end makes
/// what repeats longer.
/// @param seconds finite; outside of keys that repeat it stands for a time among them, outside of [0, kMaxKeySeconds]
/// for the nearest in it
/// @return the time of the key frame, s; of the one that was there already, where there was one
/// O(keys).
double insertKey(Track& track, double seconds);

/// Makes a key frame free, with the slopes that the curve has there.
/// @param key index, below the number of keys
void freeKey(Track& track, std::size_t key);

/// Gives a key frame slopes of its own, in its unit a second; it becomes free. A side without one keeps the slope that
/// the curve has there. A linear piece before it becomes a free one, where it is to arrive with another slope.
/// @param key index, below the number of keys
void setSlopes(Track& track, std::size_t key, const std::optional<glm::vec3>& in, const std::optional<glm::vec3>& out);

} // namespace fumage
