#pragma once

#include "ui/document/key_edits.h"

#include <vector>

namespace fumage::ui {

// What becomes of key frames that the hand drags.

/// @return index of the key at a time; the number of keys: there is none
[[nodiscard]] std::size_t keyIndex(const Track& track, double seconds);

/// The same keys at other times.
[[nodiscard]] std::vector<KeyPlace> keysAt(const std::vector<KeyPlace>& keys, const std::vector<double>& times);

/// The times of keys that are moved together, s, on whole frames; none gets before 0. Moved by nothing, they stay
/// between frames.
[[nodiscard]] std::vector<double> movedTimes(const std::vector<KeyPlace>& keys, double way, double frameRate);

/// The times of keys whose distances from the first are stretched, s, on whole frames.
/// @param from where the hand began, s @param to where it is
[[nodiscard]] std::vector<double> stretchedTimes(
    const std::vector<KeyPlace>& keys, double from, double to, double frameRate);

/// Gives free keys that are stretched as much gentler slopes, or steeper ones, so that the curve keeps its form.
void stretchSlopes(Track& track, const std::vector<KeyPlace>& keys, double from, double to);

/// Key frames with other values, in the hard range of their parameter. Choices and switches keep theirs.
/// @param component of the values that is changed; those that do not have it keep theirs
/// @param by        in the parameter's unit
void raiseKeys(Track& track, const std::vector<KeyPlace>& keys, std::size_t component, double by);

/// Gives a key frame another slope of one component, on one side or both; it becomes free.
/// @param key   index
/// @param slope in the parameter's unit a second
void bendKey(Track& track, std::size_t key, std::size_t component, double slope, bool in, bool out);

} // namespace fumage::ui
