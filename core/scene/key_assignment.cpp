#include "core/scene/key_assignment.h"

#include "core/base/joined.h"
#include "core/base/text.h"
#include "core/effect/assignment.h"
#include "core/effect/parameter_table.h"
#include "core/effect/value.h"
#include "core/scene/layer_assignment.h"

#include <algorithm>
#include <array>
#include <optional>

namespace fumage {

namespace {

Error malformed(std::string_view text)
{
    return {ErrorCode::Syntax, makeMessage("invalid key frame %1", inQuotes(text)), {},
        makeMessage("Write SECONDS:VALUE or SECONDS:VALUE:EASE, with %1 as ease", "auto, linear, hold")};
}

/// "before=loop" or "after=ping-pong". @return nothing where the text is none of them
std::optional<Status> readExtrapolation(std::string_view text, Track& track)
{
    const std::size_t equals = text.find('=');
    const std::string_view side = trimmed(text.substr(0, equals));
    if (equals == std::string_view::npos || (side != "before" && side != "after")) {
        return std::nullopt;
    }
    const std::string_view name = trimmed(text.substr(equals + 1));
    const auto at = std::find(kExtrapolations.begin(), kExtrapolations.end(), name);
    if (at == kExtrapolations.end()) {
        return Status(Error{ErrorCode::UnknownName, makeMessage("%1: no %2", side, inQuotes(name)), {},
            makeMessage("Use one of %1", joined(kExtrapolations))});
    }
    (side == "before" ? track.before : track.after) = static_cast<Extrapolation>(at - kExtrapolations.begin());
    return Status(Done{});
}

/// @return whether the value had to be clamped
Result<bool> readKey(std::string_view text, Track& track)
{
    const std::size_t parts = splitCount(text, ':');
    const std::optional<double> seconds = parseDouble(trimmed(splitPart(text, ':', 0)));
    if (!seconds || parts < 2 || parts > 3) {
        return malformed(text);
    }
    const Result<Clamped> value = parseValue(*track.parameter, trimmed(splitPart(text, ':', 1)));
    if (!value) {
        return value.error();
    }
    const Clamped inside = clampValue(*track.parameter, value.value().value);
    KeyFrame key{*seconds, inside.value};
    if (parts == 3) {
        const auto at = std::find(kEases.begin(), kEases.end(), trimmed(splitPart(text, ':', 2)));
        if (at == kEases.end() || *at == kEases.back()) {
            return malformed(text);
        }
        key.ease = static_cast<Ease>(at - kEases.begin());
    }
    setKey(track, key);
    return inside.changed || value.value().changed;
}

} // namespace

Result<bool> animateScene(Scene& scene, std::string_view text)
{
    const Result<LayerAssignment> part = layerAssignment(scene, text);
    if (!part) {
        return part.error();
    }
    const std::string_view assignment = part.value().assignment;
    const std::size_t equals = assignment.find('=');
    const std::string_view key = trimmed(assignment.substr(0, equals));
    const Parameter* parameter = findParameter(key);
    if (parameter == nullptr) {
        return noParameter(key);
    }
    Track track{parameter, {}};
    const std::string_view keys =
        equals == std::string_view::npos ? std::string_view() : trimmed(assignment.substr(equals + 1));
    bool clamped = false;
    // Of more keys than there may be checkTrack() tells.
    Parts parts(keys, ';');
    for (auto next = parts.next(); !keys.empty() && next && track.keys.size() <= kMaxKeyFrames; next = parts.next()) {
        const std::string_view item = trimmed(*next);
        if (const std::optional<Status> status = readExtrapolation(item, track)) {
            if (!*status) {
                return status->error();
            }
            continue;
        }
        const Result<bool> read = readKey(item, track);
        if (!read) {
            return read.error();
        }
        clamped = clamped || read.value();
    }
    if (const Status status = keys.empty() ? Status(Done{}) : checkTrack(track); !status) {
        return status.error();
    }
    scene.tracksOf(*parameter, part.value().layer).set(std::move(track));
    return clamped;
}

} // namespace fumage
