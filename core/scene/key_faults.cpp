#include "core/scene/key_faults.h"

#include "core/effect/known_parameter.h"
#include "core/effect/sampling.h"

#include <algorithm>
#include <cmath>

namespace fumage {

namespace {

bool isOpen(const Track& track, const Timeline& timeline)
{
    return timeline.loop && track.at(0.0) != track.at(lengthInSeconds(timeline));
}

bool jumps(const Track& track)
{
    return track.parameter->animates == Animates::Rate && track.parameter != &knownParameter("emitter.rate")
        && track.jumpsIn(track.keys.front().seconds, track.keys.back().seconds);
}

Track closed(Track track, const Timeline& timeline)
{
    const double end = lengthInSeconds(timeline);
    const Value begin = track.at(0.0);
    track.before = track.after = Extrapolation::Hold;
    std::erase_if(track.keys, [&](const KeyFrame& key) { return key.seconds >= end; });
    setKeyValue(track, 0.0, begin);
    setKeyValue(track, end, begin);
    return track;
}

Track movedIn(const Track& track, const Timeline& timeline)
{
    const double factor = lengthInSeconds(timeline) / track.keys.back().seconds;
    Track moved{track.parameter, {}, track.before, track.after};
    for (KeyFrame key : track.keys) {
        key.seconds = std::round(key.seconds * factor * timeline.frameRate) / timeline.frameRate;
        stretchSlopes(key, factor);
        setKey(moved, key);
    }
    return moved;
}

Track smoothed(Track track)
{
    for (KeyFrame& key : track.keys) {
        key = key.ease == Ease::Hold ? KeyFrame{key.seconds, key.value} : key;
    }
    return track;
}

} // namespace

std::vector<KeyFault> keyFaults(const Track& track, const Timeline& timeline)
{
    std::vector<KeyFault> faults;
    // What is moved into the timeline may close, or open, a loop: it comes first.
    if (track.keys.back().seconds > lengthInSeconds(timeline)) {
        faults.push_back(KeyFault::AfterEnd);
    }
    if (isOpen(track, timeline)) {
        faults.push_back(KeyFault::OpenLoop);
    }
    if (jumps(track)) {
        faults.push_back(KeyFault::RateJumps);
    }
    return faults;
}

Track withoutFault(const Track& track, KeyFault fault, const Timeline& timeline)
{
    switch (fault) {
    case KeyFault::OpenLoop: return isOpen(track, timeline) ? closed(track, timeline) : track;
    case KeyFault::AfterEnd:
        return track.keys.back().seconds > lengthInSeconds(timeline) ? movedIn(track, timeline) : track;
    case KeyFault::RateJumps: break;
    }
    return jumps(track) ? smoothed(track) : track;
}

bool hasKeyFaults(const Scene& scene)
{
    const auto isFaulty = [&](const Tracks& tracks) {
        return std::ranges::any_of(
            tracks.all(), [&](const Track& track) { return !keyFaults(track, scene.timeline).empty(); });
    };
    return isFaulty(scene.tracks) || std::ranges::any_of(scene.layers, [&](const Layer& layer) {
        return layer.visible && !layer.locked && isFaulty(layer.tracks);
    });
}

Scene withoutKeyFaults(const Scene& scene)
{
    Scene mended = scene;
    const auto mend = [&](Tracks& tracks) {
        for (Track track : std::vector<Track>(tracks.all().begin(), tracks.all().end())) {
            for (const KeyFault fault : {KeyFault::AfterEnd, KeyFault::OpenLoop, KeyFault::RateJumps}) {
                track = withoutFault(track, fault, scene.timeline);
            }
            tracks.set(track);
        }
    };
    mend(mended.tracks);
    for (Layer& layer : mended.layers) {
        if (layer.visible && !layer.locked) {
            mend(layer.tracks);
        }
    }
    return mended;
}

} // namespace fumage
