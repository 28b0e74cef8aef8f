#include "core/preset/marker_node.h"

#include "core/base/text.h"
#include "core/preset/preset_keys.h"

#include <algorithm>

namespace fumage {

namespace {

/// A member of a marker that is not known here; null: there is none.
const std::string* unknownMember(const JsonNode& node)
{
    if (node.type != JsonNode::Type::Object) {
        return nullptr;
    }
    const auto at = std::find_if(node.keys.begin(), node.keys.end(),
        [](const std::string& key) { return key != kMarkerName && key != kMarkerTime; });
    return at == node.keys.end() ? nullptr : &*at;
}

Result<Marker> readMarker(const JsonNode& node, const NodeTalk& talk)
{
    const JsonNode* name = node.find(kMarkerName);
    const JsonNode* time = node.find(kMarkerTime);
    const bool isMarker = name != nullptr && name->type == JsonNode::Type::String && time != nullptr
        && time->type == JsonNode::Type::Number;
    if (!isMarker) {
        return talk.error(node, ErrorCode::WrongType,
            makeMessage("a marker is an object with a %1 in quotes and a %2 in seconds", inQuotes(kMarkerName),
                inQuotes(kMarkerTime)),
            {});
    }
    Marker marker{name->string, time->number};
    if (const Status status = checkMarker(marker); !status) {
        return talk.error(node, status.error().code, status.error().message, status.error().remedy);
    }
    return marker;
}

} // namespace

Result<MarkersReading> readMarkers(const JsonNode& node, std::string_view text, const NodeTalk& talk)
{
    if (node.type != JsonNode::Type::Array) {
        return talk.error(node, ErrorCode::WrongType, makeMessage("%1: expected a list in brackets [ ]", kMarkers), {});
    }
    const auto known = static_cast<std::size_t>(std::count_if(
        node.items.begin(), node.items.end(), [](const JsonNode& item) { return unknownMember(item) == nullptr; }));
    if (known > kMaxMarkers) {
        return talk.error(
            node, ErrorCode::TooLarge, makeMessage("%1 markers, at most %2 are possible", known, kMaxMarkers), {});
    }
    MarkersReading reading;
    for (const JsonNode& item : node.items) {
        if (const std::string* key = unknownMember(item)) {
            talk.warn(
                item, makeMessage("the marker with the unknown member %1 is kept but has no effect", inQuotes(*key)));
            reading.unknown.emplace_back(text.substr(item.begin, item.end - item.begin));
            continue;
        }
        Result<Marker> marker = readMarker(item, talk);
        if (!marker) {
            return marker.error();
        }
        addMarker(reading.markers, std::move(marker).value());
    }
    return reading;
}

std::string formatMarker(const Marker& marker)
{
    return "{" + quoteJson(kMarkerName) + ": " + quoteJson(marker.name) + ", " + quoteJson(kMarkerTime) + ": "
        + formatDouble(marker.seconds) + "}";
}

} // namespace fumage
