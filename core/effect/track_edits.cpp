#include "core/effect/track_edits.h"

#include <algorithm>
#include <cmath>

namespace fumage {

namespace {

/// Whether a time lies outside of the keys, where the nearest of them holds.
bool isHeldOutside(const Track& track, double seconds)
{
    return (seconds < track.keys.front().seconds && track.before == Extrapolation::Hold)
        || (seconds > track.keys.back().seconds && track.after == Extrapolation::Hold);
}

/// Whether two slopes differ by no more than the rounding of the values that they come from.
bool areSame(const glm::vec3& a, const glm::vec3& b)
{
    constexpr float kRounding = 2e-6F;
    bool same = true;
    for (glm::length_t i = 0; i < 3; ++i) {
        same = same && std::abs(a[i] - b[i]) <= kRounding * std::max(std::abs(a[i]), std::abs(b[i]));
    }
    return same;
}

/// A new key frame on the curve.
/// @param next index of the key after it; the number of keys: there is none
KeyFrame keyOnCurve(const Track& track, std::size_t next, double seconds)
{
    KeyFrame key{seconds, track.at(seconds)};
    if (next == 0 || next == track.keys.size()) {
        return key; // as its neighbour: between equal values a smooth key is level
    }
    key.ease = track.keys[next - 1].ease;
    if (key.ease != Ease::Linear && key.ease != Ease::Hold && bends(track.parameter->kind)) {
        key.ease = Ease::Free;
        key.slopeIn = key.slopeOut = slopeBetweenKeys(track, seconds);
    }
    return key;
}

/// Lets a linear or held key frame be arrived at as before another came. Parameters are those of keepSlopes().
void keepArrival(Track& track, const Track& before, std::size_t at, std::size_t next)
{
    const std::size_t now = at < next ? at : at + 1;
    KeyFrame& key = track.keys[now];
    const bool isSmooth = at > 0 && (before.keys[at - 1].ease == Ease::Auto || before.keys[at - 1].ease == Ease::Free);
    const glm::vec3 in = isSmooth ? slopeAtKey(before, at, false) : glm::vec3(0.0F);
    if (at == 0 || (isSmooth && !areSame(slopeAtKey(track, now, false), in))) {
        key.slopeIn = in;
        key.ownArrival = at > 0;
    }
}

/// Puts back the slopes that a key frame had before another came.
/// @param before the track without that one
/// @param at     index of the key in before
/// @param next   index in before of the key that comes after the new one
void keepSlopes(Track& track, const Track& before, std::size_t at, std::size_t next)
{
    KeyFrame& key = track.keys[at < next ? at : at + 1];
    const bool isFirst = next == 0 && at == 0;
    const bool isLast = next == before.keys.size() && at + 1 == next;
    if (key.ease == Ease::Free) {
        key.slopeIn = isFirst ? glm::vec3(0.0F) : key.slopeIn;
        key.slopeOut = isLast ? glm::vec3(0.0F) : key.slopeOut;
    } else if (key.ease == Ease::Auto) {
        const glm::vec3 in = isFirst ? glm::vec3(0.0F) : slopeAtKey(before, at, false);
        const glm::vec3 out = isLast ? glm::vec3(0.0F) : slopeAtKey(before, at, true);
        const std::size_t now = at < next ? at : at + 1;
        if (!areSame(slopeAtKey(track, now, false), in) || !areSame(slopeAtKey(track, now, true), out)) {
            key = {key.seconds, key.value, Ease::Free, in, out};
        }
    } else {
        keepArrival(track, before, at, next);
    }
}

} // namespace

double insertKey(Track& track, double seconds)
{
    const double time =
        std::clamp(isHeldOutside(track, seconds) ? seconds : timeAmongKeys(track, seconds), 0.0, kMaxKeySeconds);
    if (const KeyFrame* there = keyAt(track, time)) {
        return there->seconds;
    }
    const Track before = track;
    const auto at = std::lower_bound(track.keys.begin(), track.keys.end(), time,
        [](const KeyFrame& each, double sought) { return each.seconds < sought; });
    const auto next = static_cast<std::size_t>(at - track.keys.begin());
    const KeyFrame key = keyOnCurve(before, next, time);
    track.keys.insert(at, key);
    if (bends(track.parameter->kind)) {
        Track smooth = track;
        smooth.keys[next].ease = Ease::Auto;
        const bool isSmooth = key.ease == Ease::Free && areSame(slopeAtKey(smooth, next, true), key.slopeOut);
        track.keys[next] = isSmooth ? KeyFrame{time, key.value} : key;
        for (std::size_t i = 0; i < before.keys.size(); ++i) {
            keepSlopes(track, before, i, next);
        }
    }
    return time;
}

void freeKey(Track& track, std::size_t key)
{
    const KeyFrame& was = track.keys[key];
    track.keys[key] = {was.seconds, was.value, Ease::Free, slopeAtKey(track, key, false), slopeAtKey(track, key, true)};
}

void setSlopes(Track& track, std::size_t key, const std::optional<glm::vec3>& in, const std::optional<glm::vec3>& out)
{
    freeKey(track, key);
    if (in && key > 0 && track.keys[key - 1].ease == Ease::Linear) {
        freeKey(track, key - 1);
    }
    track.keys[key].slopeIn = in.value_or(track.keys[key].slopeIn);
    track.keys[key].slopeOut = out.value_or(track.keys[key].slopeOut);
}

} // namespace fumage
