#include "ui/document/key_edits.h"

#include "ui/document/parameter_text.h"

#include "core/effect/shown_table.h"
#include "core/effect/track_edits.h"

#include <QCoreApplication>

#include <algorithm>

namespace fumage::ui {

namespace {

/// The texts of undo steps.
struct KeyEdits {
    Q_DECLARE_TR_FUNCTIONS(KeyEdits)
};

/// A track without some of its keys; where none is left the parameter has a value of its own.
void takeOut(Scene& scene, std::size_t layer, const Track& track, const Value& shown)
{
    if (track.keys.empty()) {
        Effect base = scene.effect(layer);
        track.parameter->set(base, shown);
        scene.assign(layer, base);
    }
    scene.tracksOf(*track.parameter, layer).set(track);
}

/// The layer of the reference that the one which is edited is measured by.
std::size_t referenceLayer(const Document& document)
{
    return document.layer() < document.referenceScene().layers.size() ? document.layer() : 0;
}

const Track* referenceTrack(const Document& document, const Parameter& stored)
{
    return document.referenceScene().tracksOf(stored, referenceLayer(document)).find(stored);
}

/// The tracks that hold some key frames, each once.
std::vector<Track> tracksWith(const Document& document, const std::vector<KeyPlace>& keys)
{
    std::vector<Track> tracks;
    for (const KeyPlace& key : keys) {
        const Track* track = document.track(*key.parameter);
        const bool isIn = std::any_of(
            tracks.begin(), tracks.end(), [&](const Track& each) { return each.parameter == key.parameter; });
        if (track != nullptr && !isIn) {
            tracks.push_back(*track);
        }
    }
    return tracks;
}

/// Changes how values go on from key frames, as one undo step.
/// @param change is given each with its track
template <class Change>
void changeKeys(Document& document, const std::vector<KeyPlace>& keys, const Change& change)
{
    std::vector<Track> tracks = tracksWith(document, keys);
    for (Track& track : tracks) {
        for (std::size_t key = 0; key < track.keys.size(); ++key) {
            if (holds(keys, track, track.keys[key])) {
                change(track, key);
            }
        }
    }
    replaceTracks(document, tracks, KeyEdits::tr("Ease of key frames"));
}

} // namespace

bool holds(const std::vector<KeyPlace>& keys, const Track& track, const KeyFrame& key)
{
    return std::find(keys.begin(), keys.end(), KeyPlace{track.parameter, key.seconds}) != keys.end();
}

KeyState keyState(const Document& document, const Parameter& parameter)
{
    const Track* track = document.track(parameter);
    if (track == nullptr) {
        return KeyState::None;
    }
    return keyAt(*track, document.seconds()) != nullptr ? KeyState::Here : KeyState::Animated;
}

void addKey(Document& document, const Parameter& parameter)
{
    if (!canAnimate(parameter) || !document.canEdit(parameter)) {
        return;
    }
    replaceTracks(document, {document.withKey(parameter, parameter.get(document.effect()))},
        KeyEdits::tr("Key %1").arg(fullLabelOf(parameter)));
}

std::optional<double> addKeyOnCurve(Document& document, const Parameter& parameter, double seconds)
{
    const Track* there = document.track(parameter);
    if (there == nullptr || !document.canEdit(parameter)) {
        return std::nullopt;
    }
    Track track = *there;
    const double time = insertKey(track, seconds);
    replaceTracks(document, {track}, KeyEdits::tr("Key %1").arg(fullLabelOf(parameter)));
    return time;
}

void removeKey(Document& document, const Parameter& parameter)
{
    const Track* track = document.track(parameter);
    if (const KeyFrame* key = track != nullptr ? keyAt(*track, document.seconds()) : nullptr) {
        removeKeys(document, {{&parameter, key->seconds}});
    }
}

void removeAllKeys(Document& document, const Parameter& parameter)
{
    std::vector<KeyPlace> keys;
    if (const Track* track = document.track(parameter)) {
        for (const KeyFrame& key : track->keys) {
            keys.push_back({&parameter, key.seconds});
        }
    }
    removeKeys(document, keys);
}

void replaceTracks(Document& document, const std::vector<Track>& tracks, const QString& text, Gesture gesture)
{
    Scene scene = document.scene();
    for (const Track& track : tracks) {
        if (document.canEdit(*track.parameter)) {
            scene.tracksOf(*track.parameter, document.layer()).set(track);
        }
    }
    document.replaceScene(scene, document.selection(), text, gesture);
}

std::vector<Track> withMovedKeys(
    const std::vector<Track>& base, const std::vector<KeyPlace>& keys, const std::vector<double>& moved)
{
    std::vector<Track> out;
    for (const Track& track : base) {
        Track rest{track.parameter, {}, track.before, track.after};
        for (const KeyFrame& key : track.keys) {
            if (!holds(keys, track, key)) {
                rest.keys.push_back(key);
            }
        }
        for (KeyFrame key : track.keys) {
            const auto at = std::find(keys.begin(), keys.end(), KeyPlace{track.parameter, key.seconds});
            if (at != keys.end()) {
                key.seconds = std::max(0.0, moved[static_cast<std::size_t>(at - keys.begin())]);
                setKey(rest, key);
            }
        }
        out.push_back(std::move(rest));
    }
    return out;
}

void removeKeys(Document& document, const std::vector<KeyPlace>& keys)
{
    Scene scene = document.scene();
    for (const Track& track : tracksWith(document, keys)) {
        if (document.canEdit(*track.parameter)) {
            Track rest = track;
            std::erase_if(rest.keys, [&](const KeyFrame& key) { return holds(keys, track, key); });
            takeOut(scene, document.layer(), rest, track.parameter->get(document.effect()));
        }
    }
    document.replaceScene(scene, document.selection(), KeyEdits::tr("Remove key frames"));
}

void setEase(Document& document, const std::vector<KeyPlace>& keys, Ease ease)
{
    changeKeys(document, keys, [ease](Track& track, std::size_t key) {
        if (ease == Ease::Free) {
            freeKey(track, key);
        } else {
            track.keys[key] = {track.keys[key].seconds, track.keys[key].value, ease};
        }
    });
}

void setLevel(Document& document, const std::vector<KeyPlace>& keys, bool in, bool out)
{
    const std::optional<glm::vec3> level(glm::vec3(0.0F));
    changeKeys(document, keys, [&](Track& track, std::size_t key) {
        setSlopes(track, key, in ? level : std::nullopt, out ? level : std::nullopt);
    });
}

void setExtrapolation(Document& document, const Parameter& parameter, Extrapolation before, Extrapolation after)
{
    if (const Track* track = document.track(parameter)) {
        Track changed = *track;
        changed.before = before;
        changed.after = after;
        replaceTracks(document, {changed}, KeyEdits::tr("%1 outside its key frames").arg(fullLabelOf(parameter)));
    }
}

void mendKeys(Document& document, const Parameter& parameter, KeyFault fault)
{
    if (const Track* track = document.track(parameter)) {
        replaceTracks(document, {withoutFault(*track, fault, document.scene().timeline)},
            KeyEdits::tr("Mend key frames of %1").arg(fullLabelOf(parameter)));
    }
}

void mendKeys(Document& document)
{
    document.replaceScene(withoutKeyFaults(document.scene()), document.selection(), KeyEdits::tr("Mend key frames"));
}

bool differsFromReference(const Document& document, const Parameter& parameter)
{
    const Parameter& stored = storedParameter(parameter);
    const Track* now = document.track(stored);
    const Track* before = referenceTrack(document, stored);
    const bool hasSameKeys = now == nullptr || before == nullptr ? now == before : *now == *before;
    return !hasSameKeys || !(parameter.get(document.effect()) == parameter.get(document.reference()));
}

void resetParameters(Document& document, const std::vector<const Parameter*>& parameters, const QString& text)
{
    Scene scene = document.scene();
    const Effect reference = document.referenceScene().effect(referenceLayer(document));
    Effect base = scene.effect(document.layer());
    for (const Parameter* parameter : parameters) {
        if (document.canEdit(*parameter)) {
            parameter->set(base, parameter->get(reference));
            const Track* track = referenceTrack(document, *parameter);
            scene.tracksOf(*parameter, document.layer()).set(track != nullptr ? *track : Track{parameter, {}});
        }
    }
    scene.assign(document.layer(), base);
    document.replaceScene(scene, document.selection(), text);
}

std::vector<double> keyTimes(const Document& document)
{
    std::vector<double> times;
    const Tracks tracks = document.scene().allTracks(document.layer());
    for (const Track& track : tracks.all()) {
        for (const KeyFrame& key : track.keys) {
            times.push_back(key.seconds);
        }
    }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

} // namespace fumage::ui
