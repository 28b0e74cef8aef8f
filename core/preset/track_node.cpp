#include "core/preset/track_node.h"

#include "core/base/joined.h"
#include "core/base/text.h"
#include "core/effect/parameter_table.h"
#include "core/effect/value.h"
#include "core/preset/parameter_node.h"
#include "core/preset/preset_keys.h"

#include <algorithm>
#include <array>
#include <optional>

namespace fumage {

namespace {

/// The place of a name in a list of them.
template <std::size_t Count>
std::optional<int> named(const std::array<std::string_view, Count>& names, const JsonNode& node)
{
    const auto at = std::find(names.begin(), names.end(), node.string);
    return node.type == JsonNode::Type::String && at != names.end()
        ? std::optional(static_cast<int>(at - names.begin()))
        : std::nullopt;
}

/// A slope: a number, or a list of three.
std::optional<glm::vec3> slopeOf(const JsonNode& node)
{
    if (node.type == JsonNode::Type::Number) {
        return glm::vec3(static_cast<float>(node.number), 0.0F, 0.0F);
    }
    if (node.type != JsonNode::Type::Array || node.items.size() != 3) {
        return std::nullopt;
    }
    glm::vec3 slope{0.0F};
    for (int i = 0; i < 3; ++i) {
        const JsonNode& item = node.items[static_cast<std::size_t>(i)];
        if (item.type != JsonNode::Type::Number) {
            return std::nullopt;
        }
        slope[i] = static_cast<float>(item.number);
    }
    return slope;
}

class TrackReader {
public:
    TrackReader(const Parameter& parameter, std::string_view text, const NodeTalk& talk)
        : m_text(text)
        , m_talk(talk)
    {
        m_track.parameter = &parameter;
    }

    Result<Track> read(const JsonNode& node, bool& clamped)
    {
        for (std::size_t i = 0; i < node.items.size(); ++i) {
            if (Status status = readMember(node.keys[i], node.items[i], clamped); !status) {
                return status.error();
            }
        }
        if (const Status status = checkTrack(m_track); !status) {
            const Error& error = status.error();
            return m_talk.error(node, error.code, makeMessage("%1: %2", error.place, error.message), error.remedy);
        }
        return m_track;
    }

private:
    Status readMember(const std::string& key, const JsonNode& node, bool& clamped)
    {
        if (key == kTrackKeys) {
            return readKeys(node, clamped);
        }
        if (key == kTrackBefore || key == kTrackAfter) {
            const std::optional<int> how = named(kExtrapolations, node);
            if (!how) {
                return wrong(node, makeMessage("%1: expected one of %2", key, joined(kExtrapolations)));
            }
            (key == kTrackBefore ? m_track.before : m_track.after) = static_cast<Extrapolation>(*how);
            return Done{};
        }
        return key == kTrackParameter ? Status(Done{})
                                      : wrong(node,
                                          makeMessage("a track has %1, %2, %3 and %4, and no %5", kTrackParameter,
                                              kTrackBefore, kTrackAfter, kTrackKeys, inQuotes(key)));
    }

    Status readKeys(const JsonNode& node, bool& clamped)
    {
        if (node.type != JsonNode::Type::Array) {
            return wrong(node, makeMessage("%1: expected a list in brackets [ ]", kTrackKeys));
        }
        if (node.items.size() > kMaxKeyFrames) {
            return m_talk.error(node, ErrorCode::TooLarge,
                makeMessage("%1 key frames, from 1 to %2 are possible", node.items.size(), kMaxKeyFrames), {});
        }
        for (const JsonNode& item : node.items) {
            if (Status status = readKey(item, clamped); !status) {
                return status;
            }
        }
        return Done{};
    }

    Status readKey(const JsonNode& node, bool& clamped)
    {
        const std::size_t count = node.items.size();
        const bool isKey = node.type == JsonNode::Type::Array && count >= 2 && count <= 5
            && node.items.front().type == JsonNode::Type::Number;
        if (!isKey) {
            return wrong(node, makeMessage("a key frame is a list of its seconds, its value and its ease"));
        }
        const Parameter& parameter = *m_track.parameter;
        const Result<Clamped> value = valueOf(parameter, node.items[1], m_text);
        if (!value) {
            const Error& error = value.error();
            return m_talk.error(
                node.items[1], error.code, makeMessage("%1: %2", error.place, error.message), error.remedy);
        }
        const Clamped inside = clampValue(parameter, value.value().value);
        clamped = clamped || value.value().changed || inside.changed;
        KeyFrame key{node.items.front().number, inside.value};
        if (Status status = readEase(node, key); !status) {
            return status;
        }
        m_track.keys.push_back(std::move(key));
        return Done{};
    }

    Status readEase(const JsonNode& node, KeyFrame& key)
    {
        if (node.items.size() == 2) {
            return Done{};
        }
        const std::optional<int> ease = named(kEases, node.items[2]);
        if (!ease) {
            return wrong(node.items[2], makeMessage("expected one of %1", joined(kEases)));
        }
        key.ease = static_cast<Ease>(*ease);
        return readSlopes(node, key);
    }

    Status readSlopes(const JsonNode& node, KeyFrame& key)
    {
        const std::size_t count = node.items.size() - 3;
        const bool mayArrive = key.ease == Ease::Linear || key.ease == Ease::Hold;
        if (key.ease == Ease::Free ? count != 2 : count > (mayArrive ? 1U : 0U)) {
            return wrong(node,
                makeMessage("a free key frame has two slopes, a linear or held one may have that before it, and a "
                            "smooth one has none"));
        }
        for (std::size_t i = 0; i < count; ++i) {
            const std::optional<glm::vec3> slope = slopeOf(node.items[3 + i]);
            if (!slope) {
                return wrong(node, makeMessage("a slope is a number, or a list of three"));
            }
            (i == 0 ? key.slopeIn : key.slopeOut) = *slope;
        }
        key.ownArrival = mayArrive && count == 1;
        return Done{};
    }

    [[nodiscard]] Status wrong(const JsonNode& node, const Message& message) const
    {
        return m_talk.error(node, ErrorCode::WrongType, message, {});
    }

    std::string_view m_text;
    const NodeTalk& m_talk;
    Track m_track;
};

std::string formatSlope(const Parameter& parameter, const glm::vec3& slope)
{
    return parameter.kind == Kind::Float
        ? formatFloat(slope.x)
        : "[" + formatFloat(slope.x) + ", " + formatFloat(slope.y) + ", " + formatFloat(slope.z) + "]";
}

} // namespace

Result<TracksReading> readTracks(const JsonNode& node, Scope scope, std::string_view text, const NodeTalk& talk)
{
    if (node.type != JsonNode::Type::Array) {
        return talk.error(
            node, ErrorCode::WrongType, makeMessage("%1: expected a list in brackets [ ]", kAnimation), {});
    }
    TracksReading reading;
    for (const JsonNode& item : node.items) {
        const JsonNode* key = item.find(kTrackParameter);
        if (key == nullptr || key->type != JsonNode::Type::String) {
            return talk.error(item, ErrorCode::WrongType,
                makeMessage("a track is an object with the %1 of its parameter", inQuotes(kTrackParameter)), {});
        }
        const Parameter* parameter = findParameter(key->string);
        if (parameter == nullptr || parameter->scope != scope) {
            talk.warn(item, makeMessage("the track of %1 is kept but has no effect", inQuotes(key->string)));
            reading.unknown.emplace_back(text.substr(item.begin, item.end - item.begin));
            continue;
        }
        if (reading.tracks.find(*parameter) != nullptr) {
            return talk.error(
                item, ErrorCode::OutOfRange, makeMessage("a second track of %1", inQuotes(parameter->key)), {});
        }
        bool clamped = false;
        Result<Track> track = TrackReader(*parameter, text, talk).read(item, clamped);
        if (!track) {
            return track.error();
        }
        if (clamped) {
            talk.warn(item, makeMessage("key frames of %1 were out of range", parameter->key));
        }
        reading.tracks.set(std::move(track).value());
    }
    return reading;
}

std::string formatTrack(const Track& track)
{
    const Parameter& parameter = *track.parameter;
    const auto name = [](const auto& names, auto which) { return quoteJson(names[static_cast<std::size_t>(which)]); };
    std::string out = "{" + quoteJson(kTrackParameter) + ": " + quoteJson(parameter.key);
    if (track.before != Extrapolation::Hold) {
        out += ", " + quoteJson(kTrackBefore) + ": " + name(kExtrapolations, track.before);
    }
    if (track.after != Extrapolation::Hold) {
        out += ", " + quoteJson(kTrackAfter) + ": " + name(kExtrapolations, track.after);
    }
    out += ", " + quoteJson(kTrackKeys) + ": [";
    for (const KeyFrame& key : track.keys) {
        out += &key == track.keys.data() ? "[" : ", [";
        out += formatDouble(key.seconds) + ", " + formatJson(parameter, key.value);
        if (key.ease != Ease::Auto) {
            out += ", " + name(kEases, key.ease);
        }
        if (key.ease == Ease::Free || (key.ease != Ease::Auto && key.ownArrival)) {
            out += ", " + formatSlope(parameter, key.slopeIn);
        }
        if (key.ease == Ease::Free) {
            out += ", " + formatSlope(parameter, key.slopeOut);
        }
        out += "]";
    }
    return out + "]}";
}

} // namespace fumage
