#include "core/effect/parameter_table.h"

#include "core/base/text.h"

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

namespace fumage {

namespace {

template <class T>
constexpr Kind kindOf()
{
    if constexpr (std::is_same_v<T, bool>) {
        return Kind::Bool;
    } else if constexpr (std::is_same_v<T, int>) {
        return Kind::Int;
    } else if constexpr (std::is_same_v<T, float>) {
        return Kind::Float;
    } else if constexpr (std::is_same_v<T, std::uint32_t>) {
        return Kind::Seed;
    } else if constexpr (std::is_same_v<T, Curve>) {
        return Kind::Curve;
    } else if constexpr (std::is_same_v<T, Gradient>) {
        return Kind::Gradient;
    } else if constexpr (std::is_same_v<T, glm::vec3>) {
        return Kind::Vector;
    } else {
        static_assert(std::is_enum_v<T>);
        return Kind::Choice;
    }
}

template <auto Group, auto Member>
struct Access {
    using Type = std::remove_cvref_t<decltype((std::declval<Effect&>().*Group).*Member)>;

    static Value get(const Effect& effect)
    {
        const Type& member = (effect.*Group).*Member;
        if constexpr (std::is_enum_v<Type>) {
            return static_cast<int>(member);
        } else {
            return member;
        }
    }

    static void set(Effect& effect, const Value& value)
    {
        Type& member = (effect.*Group).*Member;
        if constexpr (std::is_enum_v<Type>) {
            member = static_cast<Type>(std::get<int>(value));
        } else {
            member = std::get<Type>(value);
        }
    }
};

/// Completes a row with what follows from the member: accessors and, except for the kinds of vector, the kind.
template <auto Group, auto Member>
constexpr Parameter row(Parameter parameter)
{
    using Field = Access<Group, Member>;
    parameter.get = &Field::get;
    parameter.set = &Field::set;
    if constexpr (!std::is_same_v<typename Field::Type, glm::vec3>) {
        parameter.kind = kindOf<typename Field::Type>();
    }
    return parameter;
}

constexpr std::array<std::string_view, 3> kEmitterShapes{"rectangle", "disc", "sphere"};
constexpr std::array<std::string_view, 2> kEmissionModes{"continuous", "burst"};
constexpr std::array<std::string_view, 2> kMaskShapes{"disc", "square"};
constexpr std::array<std::string_view, 3> kNoiseBases{"lattice", "gradient", "simplex"};
constexpr std::array<std::string_view, 4> kInterpolations{"linear", "cosine", "cubic", "quintic"};
constexpr std::array<std::string_view, 2> kCameraModes{"orbit", "fixed"};
constexpr std::array<std::string_view, 2> kViewTransforms{"standard", "filmic"};
constexpr std::array<std::string_view, 2> kEmissionColours{"gradient", "black-body"};
constexpr std::array<std::string_view, 3> kQualities{"draft", "good", "final"};
constexpr std::array<std::string_view, 2> kBackgrounds{"transparent", "colour"};

constexpr Range kUnit{0.0, 1.0};
constexpr Range kFarAway{-10000.0, 10000.0};
constexpr Range kComponents{-1.0, 1.0};
constexpr Range kColours{0.0, 100.0};
constexpr Range kSeeds{0.0, 4294967295.0};
constexpr Range kEdges{1.0, 8192.0};

constexpr VisibleWhen when(std::string_view key, auto value)
{
    return {key, static_cast<int>(value)};
}

using E = Effect;

constexpr std::array kTable{
    // --- emitter ---------------------------------------------------------------------------------------------------
    row<&E::emitter, &Emitter::count>({.key = "emitter.count", .label = "Particles", .hard = {1, kMaxParticles}, .soft = {1000, 1000000}, .step = 1000, .scale = Scale::Log, .tip = "How many particles are alive once the smoke is warm. Many small ones read as smoke, few large ones as sprites.", .source = "2012 model, table of results"}),
    row<&E::emitter, &Emitter::shape>({.key = "emitter.shape", .label = "Shape", .tip = "The surface or body on which particles are born.", .source = "2012 model, eq. I (rectangle)", .choices = kEmitterShapes}),
    row<&E::emitter, &Emitter::radius>({.key = "emitter.radius", .label = "Radius", .hard = {0, 1000}, .soft = {0, 3}, .step = 0.01, .unit = Unit::Metres, .tip = "Radius of the disc or sphere."}),
    row<&E::emitter, &Emitter::width>({.key = "emitter.width", .label = "Width", .hard = {0, 1000}, .soft = {0, 10}, .step = 0.01, .unit = Unit::Metres, .tip = "Width of the rectangle, across its normal.", .source = "2012 model, eq. I", .visible = when("emitter.shape", EmitterShape::Rectangle)}),
    row<&E::emitter, &Emitter::depth>({.key = "emitter.depth", .label = "Depth", .hard = {0, 1000}, .soft = {0, 10}, .step = 0.01, .unit = Unit::Metres, .tip = "Depth of the rectangle, across its normal and its width.", .source = "2012 model, eq. I", .visible = when("emitter.shape", EmitterShape::Rectangle)}),
    row<&E::emitter, &Emitter::normal>({.key = "emitter.normal", .label = "Normal", .kind = Kind::Direction, .hard = kComponents, .soft = kComponents, .step = 0.01, .tip = "The direction N that the emitter faces and sends particles in.", .source = "2012 model, eq. I and II"}),
    row<&E::emitter, &Emitter::position>({.key = "emitter.position", .label = "Position", .kind = Kind::Vector, .hard = kFarAway, .soft = {-10, 10}, .step = 0.01, .unit = Unit::Metres, .tip = "Centre of the emitter.", .source = "2012 model, eq. I"}),
    row<&E::emitter, &Emitter::speed>({.key = "emitter.speed", .label = "Speed", .hard = {0, 1000}, .soft = {0, 10}, .step = 0.01, .unit = Unit::MetresPerSecond, .tip = "Speed at birth along the normal.", .source = "2012 model, eq. II (1 there)"}),
    row<&E::emitter, &Emitter::velocityRandomness>({.key = "emitter.velocity_randomness", .label = "Velocity randomness", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "0: every particle leaves at the full speed. 1: each component of the velocity is multiplied by its own random number.", .source = "2012 model, eq. II (1 there)"}),
    row<&E::emitter, &Emitter::spread>({.key = "emitter.spread", .label = "Spread", .hard = {0, 180}, .soft = {0, 90}, .step = 0.5, .unit = Unit::Degrees, .tip = "Half angle of the cone in which particles leave."}),
    row<&E::emitter, &Emitter::mode>({.key = "emitter.mode", .label = "Emission", .tip = "Continuous smoke, or one burst at the start of the timeline.", .choices = kEmissionModes}),
    row<&E::emitter, &Emitter::burstDuration>({.key = "emitter.burst_duration", .label = "Burst duration", .hard = {0, 1000}, .soft = {0, 5}, .step = 0.01, .unit = Unit::Seconds, .tip = "The time in which a burst gives birth to all of its particles.", .visible = when("emitter.mode", EmissionMode::Burst)}),
    row<&E::emitter, &Emitter::subframe>({.key = "emitter.subframe", .label = "Birth between steps", .tip = "Spreads births over the time between two steps, so that fast smoke leaves in a stream and not in sheets."}),
    row<&E::emitter, &Emitter::seed>({.key = "emitter.seed", .label = "Seed", .hard = kSeeds, .soft = kSeeds, .step = 1, .tip = "Another seed gives another smoke of the same kind."}),

    // --- motion ----------------------------------------------------------------------------------------------------
    row<&E::motion, &Motion::buoyancy>({.key = "motion.buoyancy", .label = "Buoyancy", .hard = {-1000, 1000}, .soft = {-2, 10}, .step = 0.05, .unit = Unit::MetresPerSecond2, .tip = "Upward acceleration of smoke that is as hot as at birth; it fades as the smoke cools.", .source = "2012 model, figure 1"}),
    row<&E::motion, &Motion::wind>({.key = "motion.wind", .label = "Wind", .hard = {0, 1000}, .soft = {0, 5}, .step = 0.01, .unit = Unit::MetresPerSecond2, .tip = "Acceleration Vw by the wind, level with the ground.", .source = "2012 model, eq. III and V"}),
    row<&E::motion, &Motion::windAngle>({.key = "motion.wind_angle", .label = "Wind angle", .hard = {-360, 360}, .soft = {-180, 180}, .step = 1, .unit = Unit::Degrees, .tip = "Angle \u03b8 of the wind in the horizontal X-Z plane; 0 blows along +X, 90 along +Z.", .source = "2012 model, eq. III and V"}),
    row<&E::motion, &Motion::gravity>({.key = "motion.gravity", .label = "Gravity", .hard = {-1000, 1000}, .soft = {-10, 10}, .step = 0.05, .unit = Unit::MetresPerSecond2, .tip = "Gravity g; divided by the mass it pulls particles down.", .source = "2012 model, eq. IV"}),
    row<&E::motion, &Motion::drag>({.key = "motion.drag", .label = "Drag", .hard = {0, 100}, .soft = {0, 5}, .step = 0.05, .unit = Unit::PerSecond, .tip = "Air resistance: the share of its velocity that a particle loses a second."}),
    row<&E::motion, &Motion::cooling>({.key = "motion.cooling", .label = "Cooling", .hard = {0, 100}, .soft = {0, 5}, .step = 0.01, .unit = Unit::PerSecond, .tip = "How fast the heat that lifts the smoke is lost."}),
    row<&E::motion, &Motion::randomness>({.key = "motion.randomness", .label = "Randomness", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "0: forces act steadily. 1: each is multiplied by a new random number every step and acts as a random walk.", .source = "2012 model, eq. XI and XII (1 there)"}),
    row<&E::motion, &Motion::gust>({.key = "motion.gust", .label = "Gusts", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "How much the strength and direction of the wind wander."}),
    row<&E::motion, &Motion::gustRate>({.key = "motion.gust_rate", .label = "Gust rate", .hard = {0, 100}, .soft = {0, 5}, .step = 0.05, .unit = Unit::Hertz, .tip = "How often the wind changes."}),
    row<&E::motion, &Motion::heatVariance>({.key = "motion.heat_variance", .label = "Heat variance", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "How much the heat at birth differs from one particle to the next; hot ones run ahead."}),
    row<&E::motion, &Motion::pull>({.key = "motion.pull", .label = "Pull to axis", .hard = {-100, 100}, .soft = {-2, 5}, .step = 0.05, .unit = Unit::PerSecond2, .tip = "Acceleration towards the vertical line through the emitter, per metre of distance: the inflow that keeps a plume together."}),
    row<&E::motion, &Motion::rotation>({.key = "motion.rotation", .label = "Rotation", .hard = {-3600, 3600}, .soft = {-180, 180}, .step = 1, .unit = Unit::DegreesPerSecond, .tip = "Mean rate at which the whole cloud turns about the vertical line through the emitter.", .source = "2012 model, whole-body rotation (0 there)"}),
    row<&E::motion, &Motion::rotationJitter>({.key = "motion.rotation_jitter", .label = "Rotation jitter", .hard = {0, 3600}, .soft = {0, 180}, .step = 1, .unit = Unit::DegreesPerSecond, .tip = "Random part of that rate, drawn anew every step.", .source = "2012 model, whole-body rotation"}),
    row<&E::motion, &Motion::mass>({.key = "motion.mass", .label = "Mass", .hard = {0.001, 1000}, .soft = {0.1, 10}, .step = 0.05, .unit = Unit::Kilograms, .scale = Scale::Log, .tip = "Mass m of a particle, which divides gravity.", .source = "2012 model, eq. IV"}),

    // --- turbulence ------------------------------------------------------------------------------------------------
    row<&E::turbulence, &Turbulence::strength>({.key = "turbulence.strength", .label = "Strength", .hard = {0, 1000}, .soft = {0, 5}, .step = 0.02, .unit = Unit::MetresPerSecond, .tip = "Typical speed of the swirls that carry the particles.", .source = "Bridson et al. 2007, curl noise"}),
    row<&E::turbulence, &Turbulence::scale>({.key = "turbulence.scale", .label = "Scale", .hard = {0.001, 1000}, .soft = {0.1, 10}, .step = 0.02, .unit = Unit::Metres, .scale = Scale::Log, .tip = "Size of the largest swirls at the height of the emitter."}),
    row<&E::turbulence, &Turbulence::octaves>({.key = "turbulence.octaves", .label = "Octaves", .hard = {1, 8}, .soft = {1, 6}, .step = 1, .tip = "Layers of ever smaller swirls; each costs the same time."}),
    row<&E::turbulence, &Turbulence::roughness>({.key = "turbulence.roughness", .label = "Roughness", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "Speed of each layer of swirls relative to the one before."}),
    row<&E::turbulence, &Turbulence::evolution>({.key = "turbulence.evolution", .label = "Evolution", .hard = {0, 100}, .soft = {0, 3}, .step = 0.02, .unit = Unit::Hertz, .tip = "How often the largest swirls become others; smaller ones change faster."}),
    row<&E::turbulence, &Turbulence::onset>({.key = "turbulence.onset", .label = "Onset", .hard = {0, 100}, .soft = {0, 5}, .step = 0.02, .unit = Unit::Seconds, .tip = "Age at which the swirls have their full strength; younger smoke is calmer."}),
    row<&E::turbulence, &Turbulence::growth>({.key = "turbulence.growth", .label = "Growth with height", .hard = {0, 10}, .soft = {0, 2}, .step = 0.02, .unit = Unit::PerMetre, .tip = "How much larger the swirls are with each metre above the emitter, as in a plume that takes in air."}),
    row<&E::turbulence, &Turbulence::drift>({.key = "turbulence.drift", .label = "Drift", .hard = {-1000, 1000}, .soft = {0, 5}, .step = 0.02, .unit = Unit::MetresPerSecond, .tip = "Speed at which the swirls rise along with the smoke, instead of standing still while it passes."}),
    row<&E::turbulence, &Turbulence::lacunarity>({.key = "turbulence.lacunarity", .label = "Lacunarity", .hard = {1, 8}, .soft = {1.5, 3}, .step = 0.05, .tip = "How many times smaller each layer of swirls is than the one before."}),

    // --- vortex ----------------------------------------------------------------------------------------------------
    row<&E::vortex, &Vortex::strength>({.key = "vortex.strength", .label = "Strength", .hard = {-1000, 1000}, .soft = {-5, 5}, .step = 0.05, .unit = Unit::MetresPerSecond, .tip = "Speed of the swirl at its radius; negative turns the other way.", .source = "Scully 1975, vortex profile"}),
    row<&E::vortex, &Vortex::radius>({.key = "vortex.radius", .label = "Radius", .hard = {0.001, 1000}, .soft = {0.05, 5}, .step = 0.01, .unit = Unit::Metres, .scale = Scale::Log, .tip = "Distance from the axis at which the swirl is fastest."}),
    row<&E::vortex, &Vortex::axis>({.key = "vortex.axis", .label = "Axis", .kind = Kind::Direction, .hard = kComponents, .soft = kComponents, .step = 0.01, .tip = "Direction of the axis through the emitter about which the smoke swirls."}),

    // --- rings -----------------------------------------------------------------------------------------------------
    row<&E::rings, &Rings::strength>({.key = "rings.strength", .label = "Strength", .hard = {0, 1000}, .soft = {0, 5}, .step = 0.05, .unit = Unit::MetresPerSecond, .tip = "Speed of the flow through the middle of the vortex rings that rise with the smoke: they roll its rim into billows, and the first one is the head of a mushroom.", .source = "Turner 1962, the starting plume"}),
    row<&E::rings, &Rings::speed>({.key = "rings.speed", .label = "Rise", .hard = {0, 1000}, .soft = {0, 5}, .step = 0.05, .unit = Unit::MetresPerSecond, .tip = "Speed at which the rings travel along the emitter's normal."}),
    row<&E::rings, &Rings::radius>({.key = "rings.radius", .label = "Radius", .hard = {0.001, 1000}, .soft = {0.05, 5}, .step = 0.01, .unit = Unit::Metres, .scale = Scale::Log, .tip = "Radius of a ring at the emitter: inside it the smoke rises, outside it sinks."}),
    row<&E::rings, &Rings::widening>({.key = "rings.widening", .label = "Widening", .hard = {0, 10}, .soft = {0, 1}, .step = 0.01, .tip = "Metres that the radius grows with each metre from the emitter."}),
    row<&E::rings, &Rings::spacing>({.key = "rings.spacing", .label = "Spacing", .hard = {0.01, 1000}, .soft = {0.2, 10}, .step = 0.05, .unit = Unit::Metres, .scale = Scale::Log, .tip = "Distance from one ring to the next."}),
    row<&E::rings, &Rings::followers>({.key = "rings.followers", .label = "Followers", .hard = {0, 4}, .soft = kUnit, .step = 0.02, .tip = "Strength of the rings that follow, relative to the first; smoke that starts warm has followers only."}),
    row<&E::rings, &Rings::variance>({.key = "rings.variance", .label = "Variance", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "How much the rings differ in strength and lie off the axis, so that they do not march in formation."}),

    // --- life ------------------------------------------------------------------------------------------------------
    row<&E::life, &Life::fadeRate>({.key = "life.fade_rate", .label = "Fade rate", .hard = {0.001, 100}, .soft = {0.005, 0.2}, .step = 0.001, .unit = Unit::PerSecond, .scale = Scale::Log, .tip = "Alpha that a particle loses a second. Its life is the initial alpha divided by this.", .source = "2012 model, eq. XIII"}),
    row<&E::life, &Life::initialAlpha>({.key = "life.initial_alpha", .label = "Initial alpha", .hard = {0.001, 1}, .soft = {0.01, 1}, .step = 0.005, .scale = Scale::Log, .tip = "Alpha Ai of a particle at birth.", .source = "2012 model, eq. XIII (0.1 there)"}),
    row<&E::life, &Life::lifetimeVariance>({.key = "life.lifetime_variance", .label = "Lifetime variance", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "Lets particles die earlier, by up to this share of their life, so that the smoke thins out unevenly."}),
    row<&E::life, &Life::sizeCurve>({.key = "life.size", .label = "Size over life", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "Share of the particle's size, from birth to death."}),
    row<&E::life, &Life::alphaCurve>({.key = "life.alpha", .label = "Alpha over life", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "Multiplies the fading alpha, from birth to death.", .stage = Stage::Shade}),

    // --- look ------------------------------------------------------------------------------------------------------
    row<&E::look, &Look::opacity>({.key = "look.opacity", .label = "Opacity", .hard = {0, 1000}, .soft = {0.05, 50}, .step = 0.05, .scale = Scale::Log, .tip = "Multiplies the alpha of every particle: from wisp to billow.", .stage = Stage::Shade}),
    row<&E::look, &Look::size>({.key = "look.size", .label = "Size", .hard = {0.001, 100}, .soft = {0.01, 3}, .step = 0.005, .unit = Unit::Metres, .scale = Scale::Log, .tip = "Largest diameter of a particle.", .stage = Stage::Shade}),
    row<&E::look, &Look::colour>({.key = "look.colour", .label = "Colour", .kind = Kind::Colour, .hard = kColours, .soft = kUnit, .step = 0.01, .tip = "Colour of the smoke itself (albedo), before light falls on it.", .stage = Stage::Shade}),
    row<&E::look, &Look::colourGradient>({.key = "look.colour_over_life", .label = "Colour over life", .hard = kColours, .soft = kUnit, .step = 0.01, .tip = "Multiplies the colour, from birth to death.", .stage = Stage::Shade}),
    row<&E::look, &Look::texture>({.key = "look.texture", .label = "Texture", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "How much the noise disturbs the transparency of a particle.", .source = "2012 model, transparency disturbance", .stage = Stage::Shade}),
    row<&E::look, &Look::erosion>({.key = "look.erosion", .label = "Erosion", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "How far the noise eats into a particle by the end of its life.", .stage = Stage::Shade}),
    row<&E::look, &Look::erosionSoftness>({.key = "look.erosion_softness", .label = "Erosion softness", .hard = {0.02, 1}, .soft = {0.02, 1}, .step = 0.01, .tip = "Width of the transition from smoke to hole.", .stage = Stage::Shade}),
    row<&E::look, &Look::softness>({.key = "look.softness", .label = "Softness", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "0: a disc with a hard rim. 1: a puff that fades from its centre.", .visible = when("look.mask", MaskShape::Disc), .stage = Stage::Shade}),
    row<&E::look, &Look::relief>({.key = "look.relief", .label = "Relief", .hard = {0, 4}, .soft = {0, 2}, .step = 0.02, .tip = "How much the noise catches the light, as bumps on a puff.", .stage = Stage::Shade}),
    row<&E::look, &Look::roundness>({.key = "look.roundness", .label = "Roundness", .hard = {0, 2}, .soft = {0, 1}, .step = 0.02, .tip = "How much a puff is shaded like a ball.", .stage = Stage::Shade}),
    row<&E::look, &Look::sizeVariance>({.key = "look.size_variance", .label = "Size variance", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "How much sizes differ; 1 mixes everything down to nothing.", .stage = Stage::Shade}),
    row<&E::look, &Look::dilution>({.key = "look.dilution", .label = "Dilution", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "How much a particle thins out as it grows; 1 keeps its amount of smoke constant.", .stage = Stage::Shade}),
    row<&E::look, &Look::textureScale>({.key = "look.texture_scale", .label = "Texture scale", .hard = {0.05, 4}, .soft = {0.1, 2}, .step = 0.01, .scale = Scale::Log, .tip = "Share of the noise tile that a particle shows; more than 1 repeats it.", .stage = Stage::Shade}),
    row<&E::look, &Look::textureRate>({.key = "look.texture_rate", .label = "Texture evolution", .hard = {0, 100}, .soft = {0, 4}, .step = 0.02, .unit = Unit::PerSecond, .tip = "How fast the noise in a particle boils: lattice cells of the third axis a second.", .stage = Stage::Shade}),
    row<&E::look, &Look::rotationVariance>({.key = "look.rotation_variance", .label = "Rotation variance", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "How much particles are turned at birth; 1 is any angle.", .stage = Stage::Shade}),
    row<&E::look, &Look::spin>({.key = "look.spin", .label = "Spin", .hard = {-3600, 3600}, .soft = {-180, 180}, .step = 1, .unit = Unit::DegreesPerSecond, .tip = "Rate at which each particle turns on the screen.", .stage = Stage::Shade}),
    row<&E::look, &Look::spinVariance>({.key = "look.spin_variance", .label = "Spin variance", .hard = {0, 3600}, .soft = {0, 180}, .step = 1, .unit = Unit::DegreesPerSecond, .tip = "Random part of that rate, different for every particle.", .stage = Stage::Shade}),
    row<&E::look, &Look::roll>({.key = "look.roll", .label = "Roll", .hard = {0, 4}, .soft = {0, 1}, .step = 0.02, .tip = "How much particles turn with the swirls that carry them; 1 is as much as the air itself."}),
    row<&E::look, &Look::stretch>({.key = "look.stretch", .label = "Stretch", .hard = {0, 1}, .soft = {0, 0.2}, .step = 0.002, .unit = Unit::Seconds, .tip = "Lengthens a particle's texture along its motion, by the way it travels in this time.", .stage = Stage::Shade}),
    row<&E::look, &Look::mask>({.key = "look.mask", .label = "Mask", .tip = "A soft round puff, or the bare square of the 2012 model.", .choices = kMaskShapes, .stage = Stage::Shade}),

    // --- noise -----------------------------------------------------------------------------------------------------
    row<&E::noise, &Noise::octaves>({.key = "noise.octaves", .label = "Octaves", .hard = {1, 10}, .soft = {1, 8}, .step = 1, .tip = "Layers of noise that are summed, each finer and weaker than the one before.", .source = "2012 model, octaves", .stage = Stage::Noise}),
    row<&E::noise, &Noise::sharpness>({.key = "noise.sharpness", .label = "Sharpness", .hard = {0.05, 20}, .soft = {0.25, 6}, .step = 0.05, .scale = Scale::Log, .tip = "Contrast of the grey values about their middle; 1 leaves them as they are.", .source = "2012 model, sharpness", .stage = Stage::Noise}),
    row<&E::noise, &Noise::wavelength>({.key = "noise.wavelength", .label = "Wavelength", .hard = {0.005, 1}, .soft = {0.05, 1}, .step = 0.01, .scale = Scale::Log, .tip = "Wavelength of the first octave as a share of the tile (the inverse of its frequency).", .source = "2012 model, octaves", .stage = Stage::Noise}),
    row<&E::noise, &Noise::persistence>({.key = "noise.persistence", .label = "Persistence", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "Amplitude of each octave relative to the one before.", .source = "2012 model, octaves", .stage = Stage::Noise}),
    row<&E::noise, &Noise::coverage>({.key = "noise.coverage", .label = "Coverage", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "How much of the tile is smoke: shifts the grey values up or down.", .stage = Stage::Noise}),
    row<&E::noise, &Noise::warp>({.key = "noise.warp", .label = "Warp", .hard = {0, 2}, .soft = {0, 0.6}, .step = 0.01, .tip = "Bends the noise by another noise, by up to this share of its wavelength.", .source = "Perlin 1985, domain perturbation", .stage = Stage::Noise}),
    row<&E::noise, &Noise::smooth>({.key = "noise.smooth", .label = "Smooth", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "Averages each lattice value with its neighbours: centre 1/4, edges 1/8, corners 1/16.", .source = "2012 model, smooth function", .visible = when("noise.basis", NoiseBasis::Lattice), .stage = Stage::Noise}),
    row<&E::noise, &Noise::basis>({.key = "noise.basis", .label = "Basis", .tip = "Random values on a lattice (2012 model), random gradients, or gradients on a lattice of simplices.", .source = "2012 model; Perlin 2002", .choices = kNoiseBases, .stage = Stage::Noise}),
    row<&E::noise, &Noise::interpolation>({.key = "noise.interpolation", .label = "Interpolation", .tip = "How values between lattice points are found.", .source = "2012 model (linear, cosine, cubic); Perlin 2002 (quintic)", .choices = kInterpolations, .stage = Stage::Noise}),
    row<&E::noise, &Noise::lacunarity>({.key = "noise.lacunarity", .label = "Lacunarity", .hard = {1, 8}, .soft = {1.5, 3}, .step = 0.05, .tip = "Frequency of each octave relative to the one before.", .source = "2012 model, octaves", .stage = Stage::Noise}),
    row<&E::noise, &Noise::depth>({.key = "noise.depth", .label = "Depth", .hard = {1, 64}, .soft = {1, 16}, .step = 1, .tip = "Lattice cells of the first octave along the third axis, through which the texture boils before it repeats.", .stage = Stage::Noise}),
    row<&E::noise, &Noise::slices>({.key = "noise.slices", .label = "Slices", .hard = {1, 128}, .soft = {1, 64}, .step = 1, .tip = "How many slices of the 3D noise are baked.", .stage = Stage::Noise}),
    row<&E::noise, &Noise::resolution>({.key = "noise.resolution", .label = "Resolution", .hard = {8, 512}, .soft = {32, 256}, .step = 32, .unit = Unit::Pixels, .tip = "Edge of the noise tile; particles use the next power of two.", .stage = Stage::Noise}),
    row<&E::noise, &Noise::seed>({.key = "noise.seed", .label = "Seed", .hard = kSeeds, .soft = kSeeds, .step = 1, .tip = "Another seed gives another texture of the same kind.", .stage = Stage::Noise}),

    // --- light -----------------------------------------------------------------------------------------------------
    row<&E::light, &Light::direction>({.key = "light.direction", .label = "Direction", .kind = Kind::Direction, .hard = kComponents, .soft = kComponents, .step = 0.01, .tip = "The direction in which the light of the sun travels.", .stage = Stage::Shade}),
    row<&E::light, &Light::intensity>({.key = "light.intensity", .label = "Intensity", .hard = {0, 1000}, .soft = {0, 10}, .step = 0.05, .tip = "Strength of the sun.", .stage = Stage::Shade}),
    row<&E::light, &Light::shadow>({.key = "light.shadow", .label = "Shadow", .hard = {0, 100}, .soft = {0, 4}, .step = 0.02, .tip = "How much light is lost on the way through the smoke.", .stage = Stage::Shade}),
    row<&E::light, &Light::scattering>({.key = "light.scattering", .label = "Scattering", .hard = {0, 0.95}, .soft = {0, 0.95}, .step = 0.01, .tip = "Light that is scattered many times and reaches deep into dense smoke, so that it is not black.", .source = "Wrenninge et al. 2013, octaves of scattering", .stage = Stage::Shade}),
    row<&E::light, &Light::anisotropy>({.key = "light.anisotropy", .label = "Anisotropy", .hard = {-0.95, 0.95}, .soft = {-0.9, 0.9}, .step = 0.01, .tip = "More than 0: smoke glows when it stands before the sun. Less: it is brighter with the sun behind the camera.", .source = "Henyey and Greenstein 1941", .stage = Stage::Shade}),
    row<&E::light, &Light::ambient>({.key = "light.ambient", .label = "Ambient", .hard = {0, 1000}, .soft = {0, 4}, .step = 0.02, .tip = "Strength of the light from sky and ground.", .stage = Stage::Shade}),
    row<&E::light, &Light::colour>({.key = "light.colour", .label = "Colour", .kind = Kind::Colour, .hard = kColours, .soft = kUnit, .step = 0.01, .tip = "Colour of the sun.", .stage = Stage::Shade}),
    row<&E::light, &Light::sky>({.key = "light.sky", .label = "Sky", .kind = Kind::Colour, .hard = kColours, .soft = kUnit, .step = 0.01, .tip = "Colour of the light from above.", .stage = Stage::Shade}),
    row<&E::light, &Light::ground>({.key = "light.ground", .label = "Ground", .kind = Kind::Colour, .hard = kColours, .soft = kUnit, .step = 0.01, .tip = "Colour of the light from below.", .stage = Stage::Shade}),
    row<&E::light, &Light::occlusion>({.key = "light.occlusion", .label = "Occlusion", .hard = {0, 100}, .soft = {0, 4}, .step = 0.02, .tip = "How much the light from sky and ground is lost inside dense smoke.", .stage = Stage::Shade}),
    row<&E::light, &Light::emission>({.key = "light.emission", .label = "Emission", .hard = {0, 1000}, .soft = {0, 20}, .step = 0.1, .tip = "Light that hot smoke gives off by itself, as fire.", .stage = Stage::Shade}),
    row<&E::light, &Light::emissionCooling>({.key = "light.emission_cooling", .label = "Emission cooling", .hard = {0, 100}, .soft = {0, 10}, .step = 0.05, .unit = Unit::PerSecond, .tip = "How fast the glow moves down its colours as smoke ages.", .stage = Stage::Shade}),
    row<&E::light, &Light::hotCore>({.key = "light.hot_core", .label = "Hot core", .hard = kUnit, .soft = kUnit, .step = 0.01, .tip = "How much cooler the rim glows than the inside: air cools what lies open to it, and fire shows in the gaps.", .stage = Stage::Shade}),
    row<&E::light, &Light::emissionColour>({.key = "light.emission_colour", .label = "Emission from", .tip = "Colours of your choice, or those of a body that glows by its temperature.", .choices = kEmissionColours, .stage = Stage::Shade}),
    row<&E::light, &Light::temperature>({.key = "light.temperature", .label = "Temperature", .hard = {600, 20000}, .soft = {900, 4000}, .step = 10, .unit = Unit::Kelvin, .tip = "Temperature at birth: 1000 K glows red, 1900 K as a candle, 5800 K as the sun. As smoke cools, its glow turns red and fades.", .source = "Planck 1901; colour matching of Wyman et al. 2013", .visible = when("light.emission_colour", EmissionColour::BlackBody), .stage = Stage::Shade}),
    row<&E::light, &Light::emissionGradient>({.key = "light.emission_colours", .label = "Emission colours", .hard = kColours, .soft = kUnit, .step = 0.01, .tip = "Colour of the glow from cold (left) to as hot as at birth (right).", .visible = when("light.emission_colour", EmissionColour::Gradient), .stage = Stage::Shade}),
    row<&E::light, &Light::resolution>({.key = "light.resolution", .label = "Resolution", .hard = {8, 256}, .soft = {32, 128}, .step = 8, .tip = "Cells of the density grid along the longest side of the cloud.", .stage = Stage::Shade}),

    // --- camera ----------------------------------------------------------------------------------------------------
    row<&E::camera, &Camera::mode>({.key = "camera.mode", .label = "Mode", .tip = "Around a target, or at a fixed place.", .choices = kCameraModes, .stage = Stage::Shade}),
    row<&E::camera, &Camera::yaw>({.key = "camera.yaw", .label = "Yaw", .hard = {-360, 360}, .soft = {-180, 180}, .step = 1, .unit = Unit::Degrees, .tip = "Angle around the target, seen from above; 0 looks along -Z.", .visible = when("camera.mode", CameraMode::Orbit), .stage = Stage::Shade}),
    row<&E::camera, &Camera::pitch>({.key = "camera.pitch", .label = "Pitch", .hard = {-89, 89}, .soft = {-89, 89}, .step = 1, .unit = Unit::Degrees, .tip = "Angle above the horizon from which the target is seen.", .visible = when("camera.mode", CameraMode::Orbit), .stage = Stage::Shade}),
    row<&E::camera, &Camera::distance>({.key = "camera.distance", .label = "Distance", .hard = {0.01, 10000}, .soft = {0.5, 50}, .step = 0.05, .unit = Unit::Metres, .scale = Scale::Log, .tip = "Distance from the target.", .visible = when("camera.mode", CameraMode::Orbit), .stage = Stage::Shade}),
    row<&E::camera, &Camera::target>({.key = "camera.target", .label = "Target", .kind = Kind::Vector, .hard = kFarAway, .soft = {-10, 10}, .step = 0.05, .unit = Unit::Metres, .tip = "The point that the camera looks at.", .visible = when("camera.mode", CameraMode::Orbit), .stage = Stage::Shade}),
    row<&E::camera, &Camera::turntable>({.key = "camera.turntable", .label = "Turntable", .hard = {-3600, 3600}, .soft = {-90, 90}, .step = 1, .unit = Unit::DegreesPerSecond, .tip = "Rate at which the camera goes around the target.", .visible = when("camera.mode", CameraMode::Orbit), .stage = Stage::Shade}),
    row<&E::camera, &Camera::position>({.key = "camera.position", .label = "Position", .kind = Kind::Vector, .hard = kFarAway, .soft = {-20, 20}, .step = 0.05, .unit = Unit::Metres, .tip = "Where the fixed camera stands.", .visible = when("camera.mode", CameraMode::Fixed), .stage = Stage::Shade}),
    row<&E::camera, &Camera::view>({.key = "camera.view", .label = "View direction", .kind = Kind::Direction, .hard = kComponents, .soft = kComponents, .step = 0.01, .tip = "Where the fixed camera looks.", .visible = when("camera.mode", CameraMode::Fixed), .stage = Stage::Shade}),
    row<&E::camera, &Camera::focalLength>({.key = "camera.focal_length", .label = "Focal length", .hard = {5, 1000}, .soft = {15, 200}, .step = 1, .unit = Unit::Millimetres, .scale = Scale::Log, .tip = "Of a lens on a sensor of 36 mm across the shorter side; longer brings the smoke nearer.", .stage = Stage::Shade}),

    // --- timeline --------------------------------------------------------------------------------------------------
    row<&E::timeline, &Timeline::length>({.key = "timeline.length", .label = "Length", .hard = {1, 100000}, .soft = {1, 600}, .step = 1, .unit = Unit::Frames, .tip = "Frames from the first to the last; also the length of the loop."}),
    row<&E::timeline, &Timeline::loop>({.key = "timeline.loop", .label = "Loop", .tip = "The frame after the last is the first again, to the bit."}),
    row<&E::timeline, &Timeline::prewarm>({.key = "timeline.prewarm", .label = "Start warm", .tip = "Frame 0 shows smoke that has been rising for a lifetime, instead of none.", .visible = when("timeline.loop", 0)}),
    row<&E::timeline, &Timeline::frameRate>({.key = "timeline.frame_rate", .label = "Frame rate", .hard = {1, 240}, .soft = {12, 60}, .step = 1, .unit = Unit::FramesPerSecond, .tip = "Frames a second."}),
    row<&E::timeline, &Timeline::stepsPerFrame>({.key = "timeline.steps_per_frame", .label = "Steps a frame", .hard = {1, 32}, .soft = {1, 8}, .step = 1, .tip = "Steps of the simulation in a frame; more follow fast motion more closely.", .source = "2012 model, eq. IX and X (1 there)"}),

    // --- output ----------------------------------------------------------------------------------------------------
    row<&E::output, &Output::width>({.key = "output.width", .label = "Width", .hard = kEdges, .soft = {64, 2048}, .step = 1, .unit = Unit::Pixels, .tip = "Width of a frame.", .stage = Stage::Shade}),
    row<&E::output, &Output::height>({.key = "output.height", .label = "Height", .hard = kEdges, .soft = {64, 2048}, .step = 1, .unit = Unit::Pixels, .tip = "Height of a frame.", .stage = Stage::Shade}),
    row<&E::output, &Output::quality>({.key = "output.quality", .label = "Quality", .tip = "Draft: a quarter of the particles. Final: eight times as many, and finer shadows. The smoke keeps its form and density.", .choices = kQualities}),
    row<&E::output, &Output::supersample>({.key = "output.supersample", .label = "Supersampling", .hard = {1, 4}, .soft = {1, 4}, .step = 1, .tip = "Renders this many times larger and averages.", .stage = Stage::Shade}),
    row<&E::output, &Output::exposure>({.key = "output.exposure", .label = "Exposure", .hard = {-20, 20}, .soft = {-4, 4}, .step = 0.05, .unit = Unit::Stops, .tip = "Brightness in stops; one more doubles it. Not applied to EXR, which is linear.", .stage = Stage::Shade}),
    row<&E::output, &Output::viewTransform>({.key = "output.view_transform", .label = "View transform", .tip = "Standard is plain sRGB; filmic rolls bright light off softly.", .choices = kViewTransforms, .stage = Stage::Shade}),
    row<&E::output, &Output::background>({.key = "output.background", .label = "Background", .tip = "Keep transparency, or put a colour behind the smoke.", .choices = kBackgrounds, .stage = Stage::Shade}),
    row<&E::output, &Output::backgroundColour>({.key = "output.background_colour", .label = "Background colour", .kind = Kind::Colour, .hard = kColours, .soft = kUnit, .step = 0.01, .tip = "The colour behind the smoke.", .visible = when("output.background", Background::Colour), .stage = Stage::Shade}),
};

// A member without a row does not compile: each struct has as many members as its group has rows.

struct AnyMember {
    template <class T>
    constexpr operator T&() const&& noexcept; // NOLINT(google-explicit-constructor): stands for a member of any type
    template <class T>
    constexpr operator T&&() const&& noexcept; // NOLINT(google-explicit-constructor)
};

template <class T, class... Members>
constexpr std::size_t memberCount()
{
    if constexpr (requires { T{Members{}..., AnyMember{}}; }) {
        return memberCount<T, Members..., AnyMember>();
    } else {
        return sizeof...(Members);
    }
}

constexpr std::size_t rowCount(std::string_view group)
{
    std::size_t count = 0;
    for (const Parameter& parameter : kTable) {
        count += parameter.group() == group ? 1U : 0U;
    }
    return count;
}

static_assert(memberCount<Effect>() == 12, "a new group needs its line below");
static_assert(memberCount<Emitter>() == rowCount("emitter"));
static_assert(memberCount<Motion>() == rowCount("motion"));
static_assert(memberCount<Turbulence>() == rowCount("turbulence"));
static_assert(memberCount<Vortex>() == rowCount("vortex"));
static_assert(memberCount<Rings>() == rowCount("rings"));
static_assert(memberCount<Life>() == rowCount("life"));
static_assert(memberCount<Look>() == rowCount("look"));
static_assert(memberCount<Noise>() == rowCount("noise"));
static_assert(memberCount<Light>() == rowCount("light"));
static_assert(memberCount<Camera>() == rowCount("camera"));
static_assert(memberCount<Timeline>() == rowCount("timeline"));
static_assert(memberCount<Output>() == rowCount("output"));

constexpr std::array<std::pair<std::string_view, std::string_view>, 12> kGroupLabels{{{"emitter", "Emitter"},
    {"motion", "Motion"},
    {"turbulence", "Turbulence"},
    {"vortex", "Vortex"},
    {"rings", "Vortex rings"},
    {"life", "Life"},
    {"look", "Look"},
    {"noise", "Noise"},
    {"light", "Light"},
    {"camera", "Camera"},
    {"timeline", "Timeline"},
    {"output", "Output"}}};

} // namespace

std::span<const Parameter> parameterTable()
{
    return kTable;
}

const Parameter* findParameter(std::string_view key)
{
    for (const Parameter& parameter : kTable) {
        if (parameter.key == key) {
            return &parameter;
        }
    }
    return nullptr;
}

std::string_view nearestParameterKey(std::string_view key)
{
    std::vector<std::string_view> keys;
    for (const Parameter& parameter : kTable) {
        keys.push_back(parameter.key);
    }
    return nearestName(key, keys);
}

std::string_view groupLabel(std::string_view group)
{
    for (const auto& [name, label] : kGroupLabels) {
        if (name == group) {
            return label;
        }
    }
    return {};
}

bool isVisible(const Parameter& parameter, const Effect& effect)
{
    const Parameter* other = parameter.visible.key.empty() ? nullptr : findParameter(parameter.visible.key);
    if (other == nullptr) {
        return true;
    }
    const Value value = other->get(effect);
    const bool* flag = std::get_if<bool>(&value);
    const int number = flag != nullptr ? static_cast<int>(*flag) : std::get<int>(value);
    return number == parameter.visible.value;
}

} // namespace fumage
