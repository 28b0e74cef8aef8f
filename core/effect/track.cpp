#include "core/effect/track.h"

#include "core/base/text.h"
#include "core/effect/value.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fumage {

namespace {

/// The numbers of a value that has others between; y and z are 0 where there is one.
using Numbers = std::array<double, 3>;

Numbers numbersOf(const Value& value)
{
    if (const auto* number = std::get_if<float>(&value)) {
        return {static_cast<double>(*number), 0.0, 0.0};
    }
    const auto& vector = std::get<glm::vec3>(value);
    return {static_cast<double>(vector.x), static_cast<double>(vector.y), static_cast<double>(vector.z)};
}

Value valueOf(const Parameter& parameter, const Numbers& numbers)
{
    if (parameter.kind == Kind::Float) {
        return clampValue(parameter, static_cast<float>(numbers[0])).value;
    }
    const glm::vec3 vector{
        static_cast<float>(numbers[0]), static_cast<float>(numbers[1]), static_cast<float>(numbers[2])};
    return clampValue(parameter, vector).value;
}

/// Steepest slope: sums of two are still numbers, also of keys that lie as near to each other as numbers can.
constexpr double kMaxSlope = 1e37;

double inReach(double slope)
{
    return std::clamp(slope, -kMaxSlope, kMaxSlope);
}

/// From one value to the other, units a second.
double secant(const KeyFrame& from, const KeyFrame& to, std::size_t component)
{
    return inReach((numbersOf(to.value)[component] - numbersOf(from.value)[component]) / (to.seconds - from.seconds));
}

/// Slope at a key between two, of secants over times: 0 where they point different ways, else their harmonic mean.
double monotoneSlope(double before, double timeBefore, double after, double timeAfter)
{
    if (before * after <= 0.0) {
        return 0.0;
    }
    const double first = 2.0 * timeAfter + timeBefore;
    const double second = timeAfter + 2.0 * timeBefore;
    return (first + second) / (first / before + second / after);
}

/// Slope at an end: of the parabola through three keys, as far as it neither turns nor overshoots.
double endSlope(double near, double timeNear, double far, double timeFar)
{
    const double slope = ((2.0 * timeNear + timeFar) * near - timeNear * far) / (timeNear + timeFar);
    if (slope * near <= 0.0) {
        return 0.0;
    }
    const bool turns = near * far <= 0.0;
    constexpr double kSteepest = 3.0; // times the secant: a steeper cubic would not be monotone
    return turns && std::abs(slope) > kSteepest * std::abs(near) ? kSteepest * near : slope;
}

/// Slope of a key that has none of its own.
double autoSlope(const std::vector<KeyFrame>& keys, std::size_t key, std::size_t component)
{
    const auto time = [&](std::size_t from) { return keys[from + 1].seconds - keys[from].seconds; };
    const auto slope = [&](std::size_t from) { return secant(keys[from], keys[from + 1], component); };
    if (keys.size() == 2) {
        return slope(0);
    }
    if (key == 0) {
        return endSlope(slope(0), time(0), slope(1), time(1));
    }
    if (key + 1 == keys.size()) {
        return endSlope(slope(key - 1), time(key - 1), slope(key - 2), time(key - 2));
    }
    return monotoneSlope(slope(key - 1), time(key - 1), slope(key), time(key));
}

/// Whether a key says which slope a smooth piece has on one side of it.
bool hasOwnSlope(const KeyFrame& key, bool after)
{
    return key.ease == Ease::Free || (key.ease != Ease::Auto && key.ownArrival && !after);
}

double slopeAt(const std::vector<KeyFrame>& keys, std::size_t key, std::size_t component, bool after)
{
    if (!hasOwnSlope(keys[key], after)) {
        return autoSlope(keys, key, component);
    }
    const glm::vec3& own = after ? keys[key].slopeOut : keys[key].slopeIn;
    return static_cast<double>(own[static_cast<glm::length_t>(component)]);
}

/// The cubic of Hermite between two keys: equal values and level slopes give the value to the bit.
double cubic(double from, double to, double slopeFrom, double slopeTo, double seconds, double share)
{
    const double rest = 1.0 - share;
    const double bend = share * rest * (rest * slopeFrom - share * slopeTo) * seconds;
    return from + (to - from) * (share * share * (3.0 - 2.0 * share)) + bend;
}

/// The shortest turn: of opposite ones there is no shortest, and the first holds half of the time.
Numbers turned(const Numbers& from, const Numbers& to, double share)
{
    Numbers out{};
    double square = 0.0;
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i] = from[i] + (to[i] - from[i]) * share;
        square += out[i] * out[i];
    }
    constexpr double kShortest = 1e-8;
    return square > kShortest ? out : share < 0.5 ? from : to;
}

/// @param key before the last @param share of the way to the next, below 1
Value between(const Track& track, std::size_t key, double share)
{
    const KeyFrame& from = track.keys[key];
    const KeyFrame& to = track.keys[key + 1];
    if (from.ease == Ease::Hold || !interpolates(track.parameter->kind) || share <= 0.0) {
        return from.value;
    }
    const Numbers a = numbersOf(from.value);
    const Numbers b = numbersOf(to.value);
    if (track.parameter->kind == Kind::Direction) {
        return a == b ? from.value : valueOf(*track.parameter, turned(a, b, share));
    }
    Numbers out{};
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i] = from.ease == Ease::Linear
            ? a[i] + (b[i] - a[i]) * share
            : cubic(a[i], b[i], slopeAt(track.keys, key, i, true), slopeAt(track.keys, key + 1, i, false),
                to.seconds - from.seconds, share);
    }
    return valueOf(*track.parameter, out);
}

/// Time since the first key, within the keys.
double folded(double time, double length, Extrapolation how)
{
    if (how == Extrapolation::Loop) {
        const double rest = std::fmod(time, length);
        return rest < 0.0 ? rest + length : rest;
    }
    const double there = std::abs(std::fmod(time, 2.0 * length));
    return there > length ? 2.0 * length - there : there;
}

/// Which of their turns the keys are in at a time: 0 from the first to the last of them, and where they do not repeat.
double turnOf(const Track& track, double seconds)
{
    const double first = track.keys.front().seconds;
    const double last = track.keys.back().seconds;
    const Extrapolation how = seconds < first ? track.before : track.after;
    if ((seconds >= first && seconds <= last) || !(last > first) || how == Extrapolation::Hold) {
        return 0.0;
    }
    const double length = last - first;
    return std::round((seconds - first - folded(seconds - first, length, Extrapolation::Loop)) / length);
}

/// Whether a held key ends in (from, to], which lies among the keys, with another value after it.
bool jumpsAmongKeys(const Track& track, double from, double to)
{
    for (std::size_t key = 0; key + 1 < track.keys.size(); ++key) {
        const double seconds = track.keys[key + 1].seconds;
        const bool isHeld = track.keys[key].ease == Ease::Hold || !interpolates(track.parameter->kind);
        if (isHeld && from < seconds && seconds <= to && track.keys[key].value != track.keys[key + 1].value) {
            return true;
        }
    }
    return false;
}

bool isFinite(const Parameter& parameter, const KeyFrame& key)
{
    if (!std::isfinite(key.seconds)) {
        return false;
    }
    const Numbers numbers = interpolates(parameter.kind) ? numbersOf(key.value) : Numbers{};
    const glm::vec3 slopes = key.slopeIn + key.slopeOut;
    return std::isfinite(numbers[0] + numbers[1] + numbers[2]) && std::isfinite(slopes.x + slopes.y + slopes.z);
}

/// The slope of the piece after a key, at its beginning or at its end, of one component.
double pieceSlope(const Track& track, std::size_t from, std::size_t component, bool atEnd)
{
    switch (track.keys[from].ease) {
    case Ease::Hold: return 0.0;
    case Ease::Linear: return secant(track.keys[from], track.keys[from + 1], component);
    case Ease::Auto:
    case Ease::Free: break;
    }
    return slopeAt(track.keys, atEnd ? from + 1 : from, component, !atEnd);
}

/// A function of the component, for those that a kind has.
template <class Slope>
glm::vec3 slopesOf(Kind kind, const Slope& slope)
{
    glm::vec3 slopes(0.0F);
    const glm::length_t count = kind == Kind::Float ? 1 : 3;
    for (glm::length_t i = 0; i < count; ++i) {
        slopes[i] = static_cast<float>(inReach(slope(static_cast<std::size_t>(i))));
    }
    return slopes;
}

} // namespace

double timeAmongKeys(const Track& track, double seconds)
{
    const double first = track.keys.front().seconds;
    const double last = track.keys.back().seconds;
    if ((seconds >= first && seconds <= last) || !(last > first)) {
        return seconds;
    }
    const Extrapolation how = seconds < first ? track.before : track.after;
    return how == Extrapolation::Hold ? std::clamp(seconds, first, last)
                                      : first + folded(seconds - first, last - first, how);
}

glm::vec3 slopeAtKey(const Track& track, std::size_t key, bool after)
{
    if (track.keys.size() < 2 || !bends(track.parameter->kind)) {
        return glm::vec3(0.0F);
    }
    const bool isAfter = key == 0 || (after && key + 1 < track.keys.size());
    return slopesOf(track.parameter->kind, [&](std::size_t component) {
        return isAfter ? pieceSlope(track, key, component, false) : pieceSlope(track, key - 1, component, true);
    });
}

glm::vec3 slopeBetweenKeys(const Track& track, double seconds)
{
    const auto next = std::upper_bound(track.keys.begin(), track.keys.end(), seconds,
        [](double sought, const KeyFrame& key) { return sought < key.seconds; });
    if (next == track.keys.begin() || next == track.keys.end() || !bends(track.parameter->kind)) {
        return glm::vec3(0.0F);
    }
    const auto key = static_cast<std::size_t>(next - track.keys.begin()) - 1;
    const KeyFrame& from = track.keys[key];
    const double share = (seconds - from.seconds) / (next->seconds - from.seconds);
    return slopesOf(track.parameter->kind, [&](std::size_t component) {
        const double begin = pieceSlope(track, key, component, false);
        const double end = pieceSlope(track, key, component, true);
        if (from.ease == Ease::Hold || from.ease == Ease::Linear) {
            return begin;
        }
        const double rest = 1.0 - share;
        return 6.0 * share * rest * secant(from, *next, component) + rest * (1.0 - 3.0 * share) * begin
            - share * (2.0 - 3.0 * share) * end;
    });
}

void stretchSlopes(KeyFrame& key, double factor)
{
    for (glm::vec3* slopes : {&key.slopeIn, &key.slopeOut}) {
        for (glm::length_t i = 0; i < slopes->length(); ++i) {
            (*slopes)[i] = static_cast<float>(inReach(static_cast<double>((*slopes)[i]) / factor));
        }
    }
}

Value Track::at(double seconds) const
{
    const double time = timeAmongKeys(*this, seconds);
    const auto next = std::upper_bound(
        keys.begin(), keys.end(), time, [](double sought, const KeyFrame& key) { return sought < key.seconds; });
    if (next == keys.begin()) {
        return keys.front().value;
    }
    if (next == keys.end()) {
        return keys.back().value;
    }
    const auto key = static_cast<std::size_t>(next - keys.begin()) - 1;
    return between(*this, key, (time - keys[key].seconds) / (next->seconds - keys[key].seconds));
}

bool Track::jumpsIn(double from, double to) const
{
    const double one = turnOf(*this, from);
    const double other = turnOf(*this, to);
    const double begin = timeAmongKeys(*this, from);
    const double end = timeAmongKeys(*this, to);
    if (one == other) {
        return jumpsAmongKeys(*this, std::min(begin, end), std::max(begin, end));
    }
    const double first = keys.front().seconds;
    const double last = keys.back().seconds;
    const bool loops =
        (one < 0.0 ? before : after) == Extrapolation::Loop || (other > 0.0 ? after : before) == Extrapolation::Loop;
    if (loops && keys.front().value != keys.back().value) {
        return true;
    }
    if (other - one > 1.0) {
        return jumpsAmongKeys(*this, first, last);
    }
    if (loops) {
        return jumpsAmongKeys(*this, begin, last) || jumpsAmongKeys(*this, first, end);
    }
    const bool turnsAtLast = std::fmod(one, 2.0) == 0.0;
    return turnsAtLast ? jumpsAmongKeys(*this, std::min(begin, end), last)
                       : jumpsAmongKeys(*this, first, std::max(begin, end));
}

bool Track::isConstant() const
{
    return std::all_of(keys.begin(), keys.end(), [&](const KeyFrame& key) {
        const bool isLevel =
            !hasOwnSlope(key, false) || (key.slopeIn == glm::vec3(0.0F) && key.slopeOut == key.slopeIn);
        return isLevel && key.value == keys.front().value;
    });
}

Status checkTrack(const Track& track)
{
    const Parameter& parameter = *track.parameter;
    const auto wrong = [&](ErrorCode code, const Message& what, const Message& remedy) {
        return Error{code, what, std::string(parameter.key), remedy};
    };
    if (!canAnimate(parameter)) {
        return wrong(ErrorCode::WrongType, makeMessage("this parameter cannot change over time"),
            makeMessage("Take its key frames out; parameters.md says which can"));
    }
    if (track.keys.empty() || track.keys.size() > kMaxKeyFrames) {
        return wrong(ErrorCode::TooLarge,
            makeMessage("%1 key frames, from 1 to %2 are possible", track.keys.size(), kMaxKeyFrames), {});
    }
    const Value like = parameter.get(Effect());
    for (std::size_t i = 0; i < track.keys.size(); ++i) {
        const KeyFrame& key = track.keys[i];
        if (key.value.index() != like.index()) {
            return wrong(ErrorCode::WrongType, makeMessage("a key frame has a value of another kind"), {});
        }
        if (!isFinite(parameter, key)) {
            return wrong(
                ErrorCode::NotFinite, makeMessage("a key frame has a time, value or slope that is no number"), {});
        }
        if (std::abs(key.seconds) > kMaxKeySeconds) {
            return wrong(ErrorCode::OutOfRange, makeMessage("a key frame lies %1 s away", formatDouble(key.seconds)),
                makeMessage("Key frames lie at most %1 s away", formatDouble(kMaxKeySeconds)));
        }
        if (i > 0 && !(track.keys[i - 1].seconds < key.seconds)) {
            return wrong(ErrorCode::OutOfRange,
                makeMessage("the key frame at %1 s comes after one at %2 s", formatDouble(key.seconds),
                    formatDouble(track.keys[i - 1].seconds)),
                makeMessage("Key frames stand in the order of their times, no two at the same"));
        }
    }
    return Done{};
}

const KeyFrame* keyAt(const Track& track, double seconds)
{
    constexpr double kSame = 1e-3;
    const auto at = std::find_if(track.keys.begin(), track.keys.end(),
        [&](const KeyFrame& key) { return std::abs(key.seconds - seconds) < kSame; });
    return at == track.keys.end() ? nullptr : &*at;
}

void setKeyValue(Track& track, double seconds, const Value& value)
{
    if (const KeyFrame* there = keyAt(track, seconds)) {
        KeyFrame key = *there;
        key.value = value;
        setKey(track, key);
        return;
    }
    KeyFrame key{seconds, value};
    for (const KeyFrame& before : track.keys) {
        key.ease = before.seconds < seconds && before.ease != Ease::Free ? before.ease : key.ease;
    }
    setKey(track, key);
}

void setKey(Track& track, const KeyFrame& key)
{
    const auto at = std::lower_bound(track.keys.begin(), track.keys.end(), key.seconds,
        [](const KeyFrame& each, double sought) { return each.seconds < sought; });
    if (at != track.keys.end() && at->seconds == key.seconds) {
        *at = key;
    } else {
        track.keys.insert(at, key);
    }
}

} // namespace fumage
