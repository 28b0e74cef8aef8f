#pragma once

#include "core/effect/parameters/row.h"

namespace fumage {

template <>
inline constexpr Group<Rings> kGroup<Rings>{&Effect::rings, "rings", "Vortex rings", Scope::Layer};

template <>
inline constexpr std::array kRows<Rings>{
    row<&Rings::strength>({
        .key = "rings.strength",
        .label = "Strength",
        .synonyms = "mushroom billow puff roll vortex",
        .hard = {0, 1000},
        .soft = {0, 5},
        .step = 0.05,
        .unit = Unit::MetresPerSecond,
        .tip = "Speed of the flow through the middle of the vortex rings that rise with the smoke: they roll its rim "
               "into billows, and the first one is the head of a mushroom.",
        .source = "Turner 1962, the starting plume",
        .animates = Animates::Step,
    }),
    row<&Rings::speed>({
        .key = "rings.speed",
        .label = "Rise",
        .synonyms = "rise velocity",
        .hard = {0, 1000},
        .soft = {0, 5},
        .step = 0.05,
        .unit = Unit::MetresPerSecond,
        .tip = "Speed at which the rings travel along the emitter's normal.",
        .animates = Animates::Rate,
    }),
    row<&Rings::radius>({
        .key = "rings.radius",
        .label = "Radius",
        .synonyms = "size",
        .hard = {0.001, 1000},
        .soft = {0.05, 5},
        .step = 0.01,
        .unit = Unit::Metres,
        .scale = Scale::Log,
        .tip = "Radius of a ring at the emitter: inside it the smoke rises, outside it sinks.",
        .animates = Animates::Step,
    }),
    row<&Rings::widening>({
        .key = "rings.widening",
        .label = "Flare",
        .synonyms = "grow expand widening",
        .hard = {0, 10},
        .soft = {0, 1},
        .step = 0.01,
        .tip = "Metres that the radius grows with each metre from the emitter.",
        .animates = Animates::Step,
    }),
    row<&Rings::spacing>({
        .key = "rings.spacing",
        .label = "Spacing",
        .synonyms = "distance puffs rate",
        .hard = {0.01, 1000},
        .soft = {0.2, 10},
        .step = 0.05,
        .unit = Unit::Metres,
        .scale = Scale::Log,
        .tip = "Distance from one ring to the next.",
    }),
    row<&Rings::followers>({
        .key = "rings.followers",
        .label = "Following rings",
        .synonyms = "repeat trail followers",
        .hard = {0, 4},
        .soft = kUnit,
        .step = 0.02,
        .tip = "Strength of the rings that follow, relative to the first; smoke that starts warm has followers only.",
        .animates = Animates::Step,
    }),
    row<&Rings::variance>({
        .key = "rings.variance",
        .label = "Variation",
        .synonyms = "random irregular variance",
        .hard = kUnit,
        .step = 0.01,
        .tip = "How much the rings differ in strength and lie off the axis, so that they do not march in formation.",
        .animates = Animates::Step,
    }),
};

} // namespace fumage
