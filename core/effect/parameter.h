#pragma once

#include "core/base/message.h"
#include "core/effect/effect.h"

#include <span>
#include <string_view>
#include <variant>

namespace fumage {

/// What a parameter is, for its editor, its JSON and its checks.
enum class Kind {
    Bool,
    Int,
    Float,
    Choice,
    Seed,
    Direction,
    Vector,
    Colour,
    Curve,
    Gradient
};

/// The unit that a value is shown and stored in.
enum class Unit {
    None,
    Metres,
    Seconds,
    PerSecond,
    MetresPerSecond,
    MetresPerSecond2,
    Degrees,
    DegreesPerSecond,
    PerMetre,
    PerSecond2,
    Hertz,
    Frames,
    FramesPerSecond,
    Pixels,
    Millimetres,
    Stops,
    Kilograms,
    Kelvin
};

enum class Scale {
    Linear,
    Log
};

/// The first stage of the work that a change makes stale; what lies before it stays valid.
enum class Stage {
    Shade, ///< light and paint the same particles again
    Noise, ///< bake the noise texture again
    Simulate, ///< step the particles again
};

/// A value of any parameter. Choice is held as the int of its enum.
using Value = std::variant<bool, int, float, std::uint32_t, glm::vec3, Curve, Gradient>;

/// The parameter matters only while another one has one value: its editor is hidden otherwise.
struct VisibleWhen {
    std::string_view key; ///< empty: always
    int value = 0; ///< of a Bool, Int or Choice
};

struct Range {
    double low = 0.0;
    double high = 0.0;
};

/// One row of the table: all there is to know about a parameter.
struct Parameter {
    std::string_view key; ///< "group.name": JSON path, --set key, objectName of the editor, anchor in the help
    std::string_view label; ///< key for tr()
    std::string_view synonyms; ///< other words that it is looked for by, with spaces between: those of other programs, of other spellings, plain ones
    Kind kind = Kind::Float;
    Range hard; ///< refused or clamped outside; of every component
    Range soft; ///< what a slider spans
    double step = 0.0;
    Unit unit = Unit::None;
    Scale scale = Scale::Linear;
    std::string_view tip;
    std::string_view source; ///< equation of the 2012 model, paper; empty where common practice
    std::span<const std::string_view> choices;
    VisibleWhen visible;
    Stage stage = Stage::Simulate;
    Value (*get)(const Effect&) = nullptr;
    void (*set)(Effect&, const Value&) = nullptr; ///< the Value must hold the alternative of the kind

    /// "emitter" of "emitter.radius".
    [[nodiscard]] constexpr std::string_view group() const { return key.substr(0, key.find('.')); }
    /// "radius" of "emitter.radius".
    [[nodiscard]] constexpr std::string_view name() const { return key.substr(key.find('.') + 1); }
};

/// The symbol after a number: "m/s", "°"; empty for Unit::None.
[[nodiscard]] std::string_view unitSymbol(Unit unit);

/// The name of a kind in messages: "a number", "true or false".
[[nodiscard]] Message kindName(Kind kind);

} // namespace fumage
