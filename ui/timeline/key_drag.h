#pragma once

#include "ui/document/key_edits.h"

#include <vector>

namespace fumage::ui {

// What becomes of key frames that the hand drags.

/// @return index of the key at a time; the number of keys: there is none
[[nodiscard]] std::size_t keyIndex(const Track& track, double seconds);

/// How far the hand has moved key frames in time.
struct KeyMove {
    double from = 0.0; ///< where it began, s
    double to = 0.0; ///< where it is, s
    bool stretches = false; ///< their distances from the first of them, in place of moving all alike
};

/// Tracks with key frames at other times, and where those are.
struct MovedKeys {
    std::vector<Track> tracks;
    std::vector<KeyPlace> keys; ///< in the order in which they were given
};

/// Gives free keys that are stretched as much gentler slopes, or steeper ones, so that the curve keeps its form.
/// @param from where the hand began, s @param to where it is
void stretchSlopes(Track& track, const std::vector<KeyPlace>& keys, double from, double to);

/// Moves key frames together to whole frames; none gets before 0. Moved by nothing, they stay between frames. Slopes
/// are those of stretchSlopes().
[[nodiscard]] MovedKeys movedKeys(
    std::vector<Track> tracks, const std::vector<KeyPlace>& keys, const KeyMove& move, double frameRate);

/// Key frames with other values, in the hard range of their parameter. Choices and switches keep theirs.
/// @param component of the values that is changed; those that do not have it keep theirs
/// @param by        in the parameter's unit
void raiseKeys(Track& track, const std::vector<KeyPlace>& keys, std::size_t component, double by);

/// Gives a key frame another slope of one component, on one side or both; it becomes free.
/// @param key   index
/// @param slope in the parameter's unit a second
void bendKey(Track& track, std::size_t key, std::size_t component, double slope, bool in, bool out);

} // namespace fumage::ui
