#pragma once

#include "core/base/result.h"
#include "core/effect/parameter.h"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace fumage {

/// How a value goes on from a key frame.
enum class Ease {
    Auto, ///< smooth, and never beyond the values of the two keys: a monotone cubic
    Linear, ///< straight to the next key
    Hold, ///< as it is until the next key
    Free, ///< smooth, with slopes of its own
};

/// What holds before the first key frame and after the last.
enum class Extrapolation {
    Hold, ///< the value of that key
    Loop, ///< the keys again
    PingPong, ///< the keys again, every other time backwards
};

/// What they are called in files.
inline constexpr std::array<std::string_view, 4> kEases{"auto", "linear", "hold", "free"};
inline constexpr std::array<std::string_view, 3> kExtrapolations{"hold", "loop", "ping-pong"};

/// The value that a parameter has at a time.
struct KeyFrame {
    double seconds = 0.0;
    Value value; ///< of the parameter's kind, in range
    Ease ease = Ease::Auto;
    /// Of a free key: how fast the value changes before and after it, in its unit a second; a number has x alone.
    glm::vec3 slopeIn{0.0F};
    glm::vec3 slopeOut{0.0F};
    /// Of a linear or held key: a smooth piece before it arrives with slopeIn, in place of the slope of a smooth key.
    bool ownArrival = false;
    friend bool operator==(const KeyFrame&, const KeyFrame&) = default;
};

/// Most key frames of a track.
inline constexpr std::size_t kMaxKeyFrames = 10'000;

/// Latest time of a key frame, s.
inline constexpr double kMaxKeySeconds = 100'000.0;

/// How a parameter changes over time: key frames, with a way between each two.
///
/// Numbers, vectors and colours go from one to the next. What has no value in between, as a choice, holds. A direction
/// is turned the shortest way. Auto keys have the slopes of Fritsch and Butland, "A Method for Constructing Local
/// Monotone Piecewise Cubic Interpolants", 1984: where values turn, and on either side of two equal ones, it is level.
struct Track {
    const Parameter* parameter = nullptr; ///< a row of the table, never null in a set of tracks
    std::vector<KeyFrame> keys; ///< in the order of their times, no two at the same; one or more
    Extrapolation before = Extrapolation::Hold;
    Extrapolation after = Extrapolation::Hold;

    /// The value at a time, in the hard range.
    /// @param seconds finite
    /// The same bits on every machine. O(log(keys)).
    [[nodiscard]] Value at(double seconds) const;
    /// Whether the value jumps in (from, to]: a held key ends there, or the track begins again.
    [[nodiscard]] bool jumpsIn(double from, double to) const;
    /// Whether all keys have the same value, and nothing bends between them.
    [[nodiscard]] bool isConstant() const;
    friend bool operator==(const Track&, const Track&) = default;
};

/// Whether a parameter can change over time.
[[nodiscard]] constexpr bool canAnimate(const Parameter& parameter)
{
    return parameter.animates != Animates::Never;
}

/// Whether values of a kind have others between them; else they hold.
[[nodiscard]] constexpr bool interpolates(Kind kind)
{
    return kind == Kind::Float || kind == Kind::Vector || kind == Kind::Direction || kind == Kind::Colour;
}

/// Whether the way from one value of a kind to the next can be bent: it has slopes.
[[nodiscard]] constexpr bool bends(Kind kind)
{
    return kind == Kind::Float || kind == Kind::Vector || kind == Kind::Colour;
}

/// The time among its key frames that a time stands for, s: outside of them where they repeat, or the nearest of them.
[[nodiscard]] double timeAmongKeys(const Track& track, double seconds);

/// How fast the value changes at a key frame, on one side of it, in its unit a second; a number has x alone.
/// @param key index, below the number of keys
/// @return 0 beside a piece that holds and where nothing bends; on the outer side of the first and last key the slope
///         of the inner side
[[nodiscard]] glm::vec3 slopeAtKey(const Track& track, std::size_t key, bool after);
/// How fast the value changes at a time between the first and the last key frame, in its unit a second, before it is
/// brought into the hard range; at a key the slope after it. 0 outside, and where nothing bends.
[[nodiscard]] glm::vec3 slopeBetweenKeys(const Track& track, double seconds);

/// A key frame of a curve that is stretched in time: its slopes are as much gentler, or steeper, as far as they are its
/// own.
/// @param factor above 0: how many times as long everything takes
void stretchSlopes(KeyFrame& key, double factor);

/// What keeps a track from being one: no key, keys that are out of order, at the same or at no time, values of another
/// kind, a parameter that cannot change over time.
/// @error OutOfRange, WrongType, TooLarge, NotFinite; the place is the parameter's key
[[nodiscard]] Status checkTrack(const Track& track);

/// Puts a key frame into a track, in place of one at its time.
void setKey(Track& track, const KeyFrame& key);
/// Gives a track a value at a time: to the key frame there, which goes on as it did, or to a new one that goes on as
/// the one before it does.
void setKeyValue(Track& track, double seconds, const Value& value);
/// @return the key frame at a time, give or take a thousandth of a second; null: there is none
[[nodiscard]] const KeyFrame* keyAt(const Track& track, double seconds);

} // namespace fumage
