#include "core/effect/parameter.h"

namespace fumage {

std::string_view unitSymbol(Unit unit)
{
    switch (unit) {
    case Unit::None: return "";
    case Unit::Metres: return "m";
    case Unit::Seconds: return "s";
    case Unit::PerSecond: return "1/s";
    case Unit::MetresPerSecond: return "m/s";
    case Unit::MetresPerSecond2: return "m/s\u00b2";
    case Unit::Degrees: return "\u00b0";
    case Unit::DegreesPerSecond: return "\u00b0/s";
    case Unit::PerMetre: return "1/m";
    case Unit::PerSecond2: return "1/s\u00b2";
    case Unit::Hertz: return "Hz";
    case Unit::Frames: return "frames";
    case Unit::FramesPerSecond: return "fps";
    case Unit::Pixels: return "px";
    case Unit::Millimetres: return "mm";
    case Unit::Stops: return "EV";
    case Unit::Kilograms: return "kg";
    case Unit::Kelvin: return "K";
    }
    return "";
}

Message kindName(Kind kind)
{
    switch (kind) {
    case Kind::Bool: return makeMessage("true or false");
    case Kind::Int: return makeMessage("a whole number");
    case Kind::Float: return makeMessage("a number");
    case Kind::Choice: return makeMessage("one of its names");
    case Kind::Seed: return makeMessage("a whole number from 0 to 4294967295");
    case Kind::Direction:
    case Kind::Vector: return makeMessage("three numbers [x, y, z]");
    case Kind::Colour: return makeMessage("three numbers [red, green, blue]");
    case Kind::Curve: return makeMessage("a list of 1 to 16 points [x, y]");
    case Kind::Gradient: return makeMessage("a list of 1 to 16 stops [at, red, green, blue]");
    case Kind::Picture: return makeMessage("a PNG in base64");
    }
    return {};
}

} // namespace fumage
