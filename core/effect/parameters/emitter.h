#pragma once

#include "core/effect/parameters/row.h"

namespace fumage {

inline constexpr std::array<std::string_view, 3> kEmitterShapes{"rectangle", "disc", "sphere"};
inline constexpr std::array<std::string_view, 2> kEmissionModes{"continuous", "burst"};

template <>
inline constexpr Group<Emitter> kGroup<Emitter>{&Effect::emitter, "emitter", "Emitter"};

template <>
inline constexpr std::array kRows<Emitter>{
    row<&Emitter::count>({
        .key = "emitter.count",
        .label = "Particles",
        .synonyms = "thick dense more number amount quantity density rate spawn",
        .hard = {1, kMaxParticles},
        .soft = {1000, 1000000},
        .step = 1000,
        .scale = Scale::Log,
        .tip = "How many particles are alive once the smoke is warm. Many small ones read as smoke, few large ones "
               "as sprites.",
        .source = "2012 model, table of results",
    }),
    row<&Emitter::shape>({
        .key = "emitter.shape",
        .label = "Shape",
        .synonyms = "source form disc disk sphere rectangle",
        .tip = "The surface or body on which particles are born.",
        .source = "2012 model, eq. I (rectangle)",
        .choices = kEmitterShapes,
    }),
    row<&Emitter::radius>({
        .key = "emitter.radius",
        .label = "Radius",
        .synonyms = "source wide narrow size diameter width",
        .hard = {0, 1000},
        .soft = {0, 3},
        .step = 0.01,
        .unit = Unit::Metres,
        .tip = "Radius of the disc or sphere.",
    }),
    row<&Emitter::width>({
        .key = "emitter.width",
        .label = "Width",
        .synonyms = "source size wide narrow",
        .hard = {0, 1000},
        .soft = {0, 10},
        .step = 0.01,
        .unit = Unit::Metres,
        .tip = "Width of the rectangle, across its normal.",
        .source = "2012 model, eq. I",
        .visible = when("emitter.shape", EmitterShape::Rectangle),
    }),
    row<&Emitter::depth>({
        .key = "emitter.depth",
        .label = "Depth",
        .synonyms = "size source length",
        .hard = {0, 1000},
        .soft = {0, 10},
        .step = 0.01,
        .unit = Unit::Metres,
        .tip = "Depth of the rectangle, across its normal and its width.",
        .source = "2012 model, eq. I",
        .visible = when("emitter.shape", EmitterShape::Rectangle),
    }),
    row<&Emitter::normal>({
        .key = "emitter.normal",
        .label = "Normal",
        .synonyms = "direction aim up orientation",
        .kind = Kind::Direction,
        .hard = kComponents,
        .step = 0.01,
        .tip = "The direction N that the emitter faces and sends particles in.",
        .source = "2012 model, eq. I and II",
    }),
    row<&Emitter::position>({
        .key = "emitter.position",
        .label = "Position",
        .synonyms = "place location source move origin",
        .kind = Kind::Vector,
        .hard = kFarAway,
        .soft = {-10, 10},
        .step = 0.01,
        .unit = Unit::Metres,
        .tip = "Centre of the emitter.",
        .source = "2012 model, eq. I",
    }),
    row<&Emitter::speed>({
        .key = "emitter.speed",
        .label = "Speed",
        .synonyms = "velocity fast slow initial jet throw strong weak",
        .hard = {0, 1000},
        .soft = {0, 10},
        .step = 0.01,
        .unit = Unit::MetresPerSecond,
        .tip = "Speed at birth along the normal.",
        .source = "2012 model, eq. II (1 there)",
    }),
    row<&Emitter::velocityRandomness>({
        .key = "emitter.velocity_randomness",
        .label = "Velocity randomness",
        .synonyms = "random chaos jitter irregular uneven wild",
        .hard = kUnit,
        .step = 0.01,
        .tip = "0: every particle leaves at the full speed. 1: each component of the velocity is multiplied by its "
               "own random number.",
        .source = "2012 model, eq. II (1 there)",
    }),
    row<&Emitter::spread>({
        .key = "emitter.spread",
        .label = "Spread",
        .synonyms = "wide narrow cone angle nozzle fan direction focused",
        .hard = {0, 180},
        .soft = {0, 90},
        .step = 0.5,
        .unit = Unit::Degrees,
        .tip = "Half angle of the cone in which particles leave, evenly over its directions; 180 is all around.",
    }),
    row<&Emitter::mode>({
        .key = "emitter.mode",
        .label = "Emission",
        .synonyms = "burst explosion puff continuous once",
        .tip = "Continuous smoke, or one burst at the start of the timeline.",
        .choices = kEmissionModes,
    }),
    row<&Emitter::burstDuration>({
        .key = "emitter.burst_duration",
        .label = "Burst duration",
        .synonyms = "burst explosion puff time",
        .hard = {0, 1000},
        .soft = {0, 5},
        .step = 0.01,
        .unit = Unit::Seconds,
        .tip = "The time in which a burst gives birth to all of its particles.",
        .visible = when("emitter.mode", EmissionMode::Burst),
    }),
    row<&Emitter::subframe>({
        .key = "emitter.subframe",
        .label = "Birth between steps",
        .synonyms = "smooth stream stripes bands",
        .tip = "Spreads births over the time between two steps, so that fast smoke leaves in a stream and not in "
               "sheets.",
    }),
    row<&Emitter::seed>({
        .key = "emitter.seed",
        .label = "Seed",
        .synonyms = "random different another",
        .hard = kSeeds,
        .step = 1,
        .tip = "Another seed gives another smoke of the same kind.",
    }),
};

} // namespace fumage
