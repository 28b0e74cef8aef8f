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
    Gradient,
    Picture
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

/// Whose a parameter is.
enum class Scope {
    Scene, ///< one value for all layers: the surroundings
    Layer, ///< each layer has its own
};

/// The first stage of the work that a change makes stale; what lies before it stays valid.
enum class DirtyStage {
    Shade, ///< light and paint the same particles again
    Noise, ///< bake the noise texture again
    Simulate, ///< step the particles again
    Air, ///< bake the air again, where there is any, and step the particles
};

/// When a value is read that changes over time.
enum class Animates {
    Never, ///< it cannot change over time
    Frame, ///< at the frame's time, for all particles
    Step, ///< at the time of each step
    Birth, ///< at the birth of each particle
    Rate, ///< summed up over time, so that a phase does not jump
};

/// Whether a parameter can be set while a LiveSimulation runs.
enum class Live {
    Changes,
    Fixed,
};

/// A value of any parameter. Choice is held as the int of its enum.
using Value = std::variant<bool, int, float, std::uint32_t, glm::vec3, Curve, Gradient, Bitmap>;

/// The parameter matters only while another one has one value, or one of two: its editor is hidden otherwise.
struct VisibleWhen {
    std::string_view key; ///< empty: always
    int value = 0; ///< of a Bool, Int or Choice
    int other = value; ///< the second one
};

struct Range {
    double low = 0.0;
    double high = 0.0;
};

/// One row of the table: all there is to know about a parameter.
struct Parameter {
    std::string_view key; ///< "group.name": JSON path, --set key, objectName of the editor, anchor in the help
    std::string_view formerly; ///< the key that earlier versions of files have; empty: the same
    int since = 1; ///< first version of presets that has it: those of earlier ones do not lack it
    std::string_view label; ///< key for tr()
    std::string_view synonyms; ///< other words that it is looked for by, with spaces between: those of other programs,
                               ///< of other spellings, plain ones
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
    bool ofBorn = false; ///< matters only to a layer whose particles are born on those of another
    DirtyStage dirties = DirtyStage::Simulate;
    Animates animates = Animates::Never;
    /// Part of the smoke's character: variations change it, as far as its kind can be moved a little
    bool varies = true;
    int essential = 0; ///< place among the essentials at the top of the panel, from 1; 0: not one of them
    Live live = Live::Changes;
    bool atExport = false; ///< asked for in the export dialog, too
    Scope scope = Scope::Layer; ///< that of its group
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
