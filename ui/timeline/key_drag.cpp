#include "ui/timeline/key_drag.h"

#include "ui/timeline/graph_curves.h"

#include "core/effect/track_edits.h"

#include <algorithm>
#include <cmath>

namespace fumage::ui {

namespace {

double firstOf(const std::vector<KeyPlace>& keys)
{
    double first = kMaxKeySeconds;
    for (const KeyPlace& key : keys) {
        first = std::min(first, key.seconds);
    }
    return first;
}

double onFrame(double seconds, double frameRate)
{
    return std::clamp(std::round(seconds * frameRate) / frameRate, 0.0, kMaxKeySeconds);
}

/// How many times as far keys come to lie from the first.
double stretchOf(const std::vector<KeyPlace>& keys, double from, double to)
{
    const double first = firstOf(keys);
    return from > first ? std::max(0.0, (to - first) / (from - first)) : 1.0;
}

std::vector<KeyPlace> keysAt(const std::vector<KeyPlace>& keys, const std::vector<double>& times)
{
    std::vector<KeyPlace> moved;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        moved.push_back({keys[i].parameter, times[i]});
    }
    return moved;
}

std::vector<double> movedTimes(const std::vector<KeyPlace>& keys, double way, double frameRate)
{
    const double inside = std::max(-firstOf(keys), way);
    std::vector<double> times;
    for (const KeyPlace& key : keys) {
        times.push_back(way == 0.0 ? key.seconds : onFrame(key.seconds + inside, frameRate));
    }
    return times;
}

std::vector<double> stretchedTimes(const std::vector<KeyPlace>& keys, double from, double to, double frameRate)
{
    const double first = firstOf(keys);
    const double factor = stretchOf(keys, from, to);
    std::vector<double> times;
    for (const KeyPlace& key : keys) {
        times.push_back(factor == 1.0 ? key.seconds : onFrame(first + (key.seconds - first) * factor, frameRate));
    }
    return times;
}

} // namespace

std::size_t keyIndex(const Track& track, double seconds)
{
    const auto at =
        std::find_if(track.keys.begin(), track.keys.end(), [&](const KeyFrame& key) { return key.seconds == seconds; });
    return static_cast<std::size_t>(at - track.keys.begin());
}

void stretchSlopes(Track& track, const std::vector<KeyPlace>& keys, double from, double to)
{
    const double factor = stretchOf(keys, from, to);
    for (KeyFrame& key : track.keys) {
        if (factor > 0.0 && holds(keys, track, key)) {
            fumage::stretchSlopes(key, factor);
        }
    }
}

MovedKeys movedKeys(std::vector<Track> tracks, const std::vector<KeyPlace>& keys, const KeyMove& move, double frameRate)
{
    if (!move.stretches) {
        const std::vector<double> times = movedTimes(keys, move.to - move.from, frameRate);
        return {withMovedKeys(tracks, keys, times), keysAt(keys, times)};
    }
    for (Track& track : tracks) {
        stretchSlopes(track, keys, move.from, move.to);
    }
    const std::vector<double> times = stretchedTimes(keys, move.from, move.to, frameRate);
    return {withMovedKeys(tracks, keys, times), keysAt(keys, times)};
}

void raiseKeys(Track& track, const std::vector<KeyPlace>& keys, std::size_t component, double by)
{
    const Parameter& parameter = *track.parameter;
    if (by == 0.0 || !isRaised(parameter.kind) || component >= componentCount(parameter.kind)) {
        return;
    }
    for (KeyFrame& key : track.keys) {
        if (holds(keys, track, key)) {
            key.value = withComponent(parameter, key.value, component, componentOf(key.value, component) + by);
        }
    }
}

void bendKey(Track& track, std::size_t key, std::size_t component, double slope, bool in, bool out)
{
    const auto side = [&](bool after) {
        glm::vec3 slopes = slopeAtKey(track, key, after);
        slopes[static_cast<glm::length_t>(component)] = static_cast<float>(slope);
        return slopes;
    };
    const std::optional<glm::vec3> before = in ? std::optional(side(false)) : std::nullopt;
    const std::optional<glm::vec3> after = out ? std::optional(side(true)) : std::nullopt;
    setSlopes(track, key, before, after);
}

} // namespace fumage::ui
