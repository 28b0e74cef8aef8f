#include "core/scene/marker.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace fumage {

namespace {

/// A text's first bytes, without a part of a character at their end.
std::string_view cut(std::string_view text, std::size_t most)
{
    std::size_t length = std::min(text.size(), most);
    while (length > 0 && length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) {
        --length;
    }
    return text.substr(0, length);
}

Status checkName(const std::string& name)
{
    if (!isUtf8(name)) {
        return Error{ErrorCode::NotUtf8, makeMessage("the name of a marker is not UTF-8"), {}, {}};
    }
    if (name.size() > kMaxMarkerName) {
        return Error{ErrorCode::TooLarge, makeMessage("a marker's name of %1 bytes", name.size()), {},
            makeMessage("Names have at most %1", kMaxMarkerName)};
    }
    if (name.empty() || printable(name) != name) {
        return Error{ErrorCode::WrongType,
            makeMessage("the name of a marker is empty or has control characters: %1", inQuotes(name)), {},
            makeMessage("Name it with letters, digits, spaces and signs")};
    }
    return Done{};
}

} // namespace

Status checkMarker(const Marker& marker)
{
    if (!std::isfinite(marker.seconds)) {
        return Error{ErrorCode::NotFinite, makeMessage("the time of a marker is no number"), {}, {}};
    }
    if (marker.seconds < 0.0 || marker.seconds > kMaxMarkerSeconds) {
        return Error{ErrorCode::OutOfRange, makeMessage("a marker lies at %1 s", formatDouble(marker.seconds)), {},
            makeMessage("Markers lie from 0 to %1 s", static_cast<int>(kMaxMarkerSeconds))};
    }
    return checkName(marker.name);
}

Status checkMarkers(std::span<const Marker> markers)
{
    if (markers.size() > kMaxMarkers) {
        return Error{ErrorCode::TooLarge,
            makeMessage("%1 markers, at most %2 are possible", markers.size(), kMaxMarkers), {}, {}};
    }
    for (std::size_t i = 0; i < markers.size(); ++i) {
        if (Status status = checkMarker(markers[i]); !status) {
            return status;
        }
        if (i > 0 && markers[i].seconds < markers[i - 1].seconds) {
            return Error{ErrorCode::OutOfRange,
                makeMessage("the marker at %1 s comes after one at %2 s", formatDouble(markers[i].seconds),
                    formatDouble(markers[i - 1].seconds)),
                {}, makeMessage("Markers stand in the order of their times")};
        }
    }
    return Done{};
}

std::size_t addMarker(std::vector<Marker>& markers, Marker marker)
{
    const auto after = std::upper_bound(markers.begin(), markers.end(), marker.seconds,
        [](double seconds, const Marker& each) { return seconds < each.seconds; });
    const auto at = markers.insert(after, std::move(marker));
    return static_cast<std::size_t>(at - markers.begin());
}

std::string markerNameOf(std::string_view text)
{
    const std::string plain = printable(text);
    return std::string(trimmed(cut(trimmed(plain), kMaxMarkerName)));
}

} // namespace fumage
