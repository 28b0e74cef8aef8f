#include "core/scene/key_table.h"

#include "core/base/text.h"
#include "core/effect/value.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fumage {

namespace {

bool hasThreeParts(const Parameter& parameter)
{
    return parameter.kind == Kind::Vector || parameter.kind == Kind::Direction || parameter.kind == Kind::Colour;
}

/// What stands between the cells of a line.
char separatorOf(std::string_view line)
{
    for (const char separator : {'\t', ';'}) {
        if (line.find(separator) != std::string_view::npos) {
            return separator;
        }
    }
    return ',';
}

/// The cells after the first, as parseValue() reads them.
std::string valueOf(std::string_view line, char separator)
{
    const std::size_t first = line.find(separator);
    std::string value(first == std::string_view::npos ? std::string_view() : trimmed(line.substr(first + 1)));
    std::replace(value.begin(), value.end(), separator, ',');
    return value;
}

Error inLine(Error error, std::size_t line)
{
    error.place = makeMessage("line %1", line);
    return error;
}

} // namespace

std::string formatKeyTable(const Track& track)
{
    std::string table = hasThreeParts(*track.parameter) ? "seconds,x,y,z\n" : "seconds,value\n";
    for (const KeyFrame& key : track.keys) {
        std::string value = formatText(*track.parameter, key.value);
        std::erase_if(value, [](char c) { return c == '[' || c == ']' || c == ' '; });
        table += formatDouble(key.seconds) + "," + value + "\n";
    }
    return table;
}

Result<Track> parseKeyTable(const Parameter& parameter, std::string_view text, int frameRate)
{
    Track track{&parameter, {}};
    double perSecond = 1.0;
    Parts lines(text, '\n');
    for (std::size_t number = 1; const std::optional<std::string_view> part = lines.next(); ++number) {
        const std::string_view line = trimmed(*part);
        if (line.empty()) {
            continue;
        }
        const char separator = separatorOf(line);
        const std::string_view first = trimmed(splitPart(line, separator, 0));
        const std::optional<double> time = parseDouble(first);
        if (!time && number == 1) {
            perSecond = inSmallLetters(first).starts_with("frame") ? frameRate : 1.0;
            continue;
        }
        if (!time || !std::isfinite(*time)) {
            return inLine({ErrorCode::Syntax, makeMessage("%1 is no time", inQuotes(first)), {},
                              makeMessage("Write seconds, then the value, with commas between")},
                number);
        }
        const Result<Clamped> value = parseValue(parameter, valueOf(line, separator));
        if (!value) {
            return inLine(value.error(), number);
        }
        if (track.keys.size() > kMaxKeyFrames) {
            break; // checkTrack() says so
        }
        setKey(track, {*time / perSecond, clampValue(parameter, value.value().value).value});
    }
    const Status status = checkTrack(track);
    return status ? Result<Track>(std::move(track)) : status.error();
}

} // namespace fumage
