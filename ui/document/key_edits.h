#pragma once

#include "ui/document/document.h"

#include "core/scene/key_faults.h"

#include <optional>
#include <vector>

namespace fumage::ui {

// What is done to key frames: each is one undo step.

/// How a parameter stands at the time that is shown.
enum class KeyState {
    None, ///< it does not change over time
    Animated, ///< it does, and has no key frame there
    Here, ///< it has one there
};
[[nodiscard]] KeyState keyState(const Document& document, const Parameter& parameter);

/// Puts a key frame at the time that is shown, with the value that the parameter has there.
void addKey(Document& document, const Parameter& parameter);
/// Puts a key frame on the curve of a parameter that changes over time, without moving the curve: see insertKey().
/// @return its time, s; nothing: the parameter does not change over time, or its layer is locked
std::optional<double> addKeyOnCurve(Document& document, const Parameter& parameter, double seconds);
/// Takes the key frame at the time that is shown away; with the last one the parameter keeps its value.
void removeKey(Document& document, const Parameter& parameter);
/// Takes all key frames away; the parameter keeps the value that is shown.
void removeAllKeys(Document& document, const Parameter& parameter);

/// One key frame of a parameter.
struct KeyPlace {
    const Parameter* parameter = nullptr;
    double seconds = 0.0;
    friend bool operator==(const KeyPlace&, const KeyPlace&) = default;
};

/// Whether a key frame of a track is one of several.
[[nodiscard]] bool holds(const std::vector<KeyPlace>& keys, const Track& track, const KeyFrame& key);

/// Sets other tracks in place of those of their parameters.
/// @param text of the undo step
void replaceTracks(Document& document, const std::vector<Track>& tracks, const QString& text, Gesture gesture = {});
/// Moves key frames in time; where two would come together, the one that is moved stays. None gets before 0.
/// @param base   tracks as they were before the gesture
/// @param moved  time of each, s, from its time in base
[[nodiscard]] std::vector<Track> withMovedKeys(
    const std::vector<Track>& base, const std::vector<KeyPlace>& keys, const std::vector<double>& moved);
/// Takes key frames away; a parameter that loses its last one keeps the value that is shown.
void removeKeys(Document& document, const std::vector<KeyPlace>& keys);
/// Sets how values go on from key frames; free ones begin with the slopes that they have.
void setEase(Document& document, const std::vector<KeyPlace>& keys, Ease ease);
/// Lets values come to rest at key frames, or leave them from rest, or both: free ones that are level on that side.
void setLevel(Document& document, const std::vector<KeyPlace>& keys, bool in, bool out);
/// Sets what holds before and after the key frames of a parameter.
void setExtrapolation(Document& document, const Parameter& parameter, Extrapolation before, Extrapolation after);

/// Mends what key frames of one parameter do that nobody may want; see withoutFault().
void mendKeys(Document& document, const Parameter& parameter, KeyFault fault);
/// The same of all parameters of all visible layers that are not locked.
void mendKeys(Document& document);

/// Whether a parameter has another value than what was loaded or last saved, or other key frames.
/// @param parameter of the table, or a derived one
[[nodiscard]] bool differsFromReference(const Document& document, const Parameter& parameter);
/// Sets parameters back to what was loaded or last saved, key frames too; those of a locked layer stay.
/// @param parameters of the table
/// @param text       of the undo step
void resetParameters(Document& document, const std::vector<const Parameter*>& parameters, const QString& text);

/// Times of all key frames of the layer that is edited and of what all layers share, in order, each once.
[[nodiscard]] std::vector<double> keyTimes(const Document& document);

} // namespace fumage::ui
