#pragma once

#include "core/base/result.h"
#include "core/effect/track.h"

#include <string>
#include <string_view>

namespace fumage {

/// The key frames of a parameter as a table in CSV, a line each under its heading: "seconds,x,y,z" of what has three
/// parts, else "seconds,value". Eases are not part of it.
[[nodiscard]] std::string formatKeyTable(const Track& track);

/// Reads what formatKeyTable() writes, and tables of other programs: with commas, semicolons or tabs between, with or
/// without a heading, whose first word may be "frame" in place of seconds; in any order of times. Of two lines of one
/// time the later one counts.
/// @param frameRate of tables that count frames
/// @return the track without extrapolation; values are clamped into the hard range
/// @error Syntax, with the line, and those of parseValue() and checkTrack()
[[nodiscard]] Result<Track> parseKeyTable(const Parameter& parameter, std::string_view text, int frameRate);

} // namespace fumage
