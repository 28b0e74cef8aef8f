#pragma once

#include "core/effect/parameters/row.h"

namespace fumage {

inline constexpr std::array<std::string_view, 3> kCouplings{"carried", "dragged", "free"};

template <>
inline constexpr Group<Motion> kGroup<Motion>{&Effect::motion, "motion", "Motion", Scope::Layer};

template <>
inline constexpr std::array kRows<Motion>{
    row<&Motion::coupling>({
        .key = "motion.coupling",
        .since = 2,
        .label = "In the air",
        .synonyms = "advect carried dragged inertia ballistic free heavy sparks embers debris collide",
        .tip = "Carried: particles are the air's, as smoke is. Dragged: they have a velocity of their own, which drag "
               "takes towards the air's, as embers and debris have. Free: no air touches them. What is dragged or free "
               "bounces off ground and obstacle.",
        .choices = kCouplings,
        .visible = when("air.enabled", true),
        .varies = false,
    }),
    row<&Motion::restitution>({
        .key = "motion.restitution",
        .since = 2,
        .label = "Bounce",
        .synonyms = "restitution elastic rebound collision",
        .hard = kUnit,
        .step = 0.02,
        .tip = "Share of its speed with which a dragged or free particle leaves ground and obstacle again.",
        .visible = when("air.enabled", true),
        .animates = Animates::Step,
    }),
    row<&Motion::friction>({
        .key = "motion.friction",
        .since = 2,
        .label = "Contact friction",
        .synonyms = "slide stick roll collision ground",
        .hard = kUnit,
        .step = 0.02,
        .tip = "Share of its speed along ground or obstacle that a dragged or free particle loses in each touch.",
        .visible = when("air.enabled", true),
        .animates = Animates::Step,
    }),
    row<&Motion::buoyancy>({
        .key = "motion.buoyancy",
        .label = "Buoyancy",
        .synonyms = "rise lift tall high fast heat hot up float climb",
        .hard = {-1000, 1000},
        .soft = {-2, 10},
        .step = 0.05,
        .unit = Unit::MetresPerSecond2,
        .tip = "Upward acceleration of smoke that is as hot as at birth; it fades as the smoke cools.",
        .source = "2012 model, figure 1",
        .visible = when("air.enabled", false),
        .animates = Animates::Step,
    }),
    row<&Motion::gravity>({
        .key = "motion.gravity",
        .label = "Gravity",
        .synonyms = "fall weight down heavy sink drop light",
        .hard = {-1000, 1000},
        .soft = {-10, 10},
        .step = 0.05,
        .unit = Unit::MetresPerSecond2,
        .tip = "Gravity g; divided by the mass it pulls particles down.",
        .source = "2012 model, eq. IV",
        .animates = Animates::Step,
        .essential = 7,
    }),
    row<&Motion::drag>({
        .key = "motion.drag",
        .label = "Drag",
        .synonyms = "friction slow air resistance damping brake calm",
        .hard = {0, 100},
        .soft = {0, 5},
        .step = 0.05,
        .unit = Unit::PerSecond,
        .tip = "Air resistance: the share of its velocity that a particle loses a second.",
        .animates = Animates::Step,
    }),
    row<&Motion::cooling>({
        .key = "motion.cooling",
        .label = "Cooling",
        .synonyms = "heat cold temperature short low",
        .hard = {0, 100},
        .soft = {0, 5},
        .step = 0.01,
        .unit = Unit::PerSecond,
        .tip = "How fast the heat that lifts the smoke is lost.",
        .animates = Animates::Step,
    }),
    row<&Motion::randomness>({
        .key = "motion.randomness",
        .label = "Randomness",
        .synonyms = "chaos jitter random noise irregular wild messy",
        .hard = kUnit,
        .step = 0.01,
        .tip = "0: forces act steadily. 1: each is multiplied by a new random number every frame and acts as a random "
               "walk. Steps per frame do not change how far it leads; a higher frame rate shortens it.",
        .source = "2012 model, eq. XI and XII (1 there)",
        .animates = Animates::Step,
    }),
    row<&Motion::heatVariance>({
        .key = "motion.heat_variance",
        .label = "Heat variation",
        .synonyms = "random hot rise heat variance",
        .hard = kUnit,
        .step = 0.01,
        .tip = "How much the heat at birth differs from one particle to the next, around the same mean; hot ones run "
               "ahead.",
        .animates = Animates::Step,
    }),
    row<&Motion::pull>({
        .key = "motion.pull",
        .label = "Attract to axis",
        .synonyms = "attract inflow narrow thin column tight pull to axis",
        .hard = {-100, 100},
        .soft = {-2, 5},
        .step = 0.05,
        .unit = Unit::PerSecond2,
        .tip = "Acceleration towards the vertical line through the emitter, per metre of distance: the inflow that "
               "keeps a plume together.",
        .animates = Animates::Step,
    }),
    row<&Motion::rotation>({
        .key = "motion.rotation",
        .label = "Rotation",
        .synonyms = "spin turn swirl twist whirl",
        .hard = {-3600, 3600},
        .soft = {-180, 180},
        .step = 1,
        .unit = Unit::DegreesPerSecond,
        .tip =
            "Mean rate at which the whole cloud turns about the vertical line through the emitter: from +X towards -Z, "
            "against the sense of the wind's angle. The emitter does not turn.",
        .source = "2012 model, whole-body rotation (0 there)",
        .animates = Animates::Step,
    }),
    row<&Motion::rotationJitter>({
        .key = "motion.rotation_jitter",
        .label = "Rotation jitter",
        .synonyms = "spin random",
        .hard = {0, 3600},
        .soft = {0, 180},
        .step = 1,
        .unit = Unit::DegreesPerSecond,
        .tip = "Random part of that rate, drawn anew every frame. Steps per frame do not change how far it turns; a "
               "higher frame rate does.",
        .source = "2012 model, whole-body rotation",
        .animates = Animates::Step,
    }),
    row<&Motion::mass>({
        .key = "motion.mass",
        .label = "Mass",
        .synonyms = "weight heavy light",
        .hard = {0.001, 1000},
        .soft = {0.1, 10},
        .step = 0.05,
        .unit = Unit::Kilograms,
        .scale = Scale::Log,
        .tip = "Mass m of a particle, which divides gravity.",
        .source = "2012 model, eq. IV",
        .animates = Animates::Step,
    }),
};

} // namespace fumage
