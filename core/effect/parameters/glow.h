#pragma once

#include "core/effect/parameters/row.h"

namespace fumage {

template <>
inline constexpr Group<Glow> kGroup<Glow>{&Effect::glow, "glow", "Fire", Scope::Layer};

inline constexpr std::array<std::string_view, 2> kEmissionColours{"gradient", "black-body"};

template <>
inline constexpr std::array kRows<Glow>{
    row<&Glow::emission>({
        .key = "glow.emission",
        .formerly = "light.emission",
        .label = "Fire brightness",
        .synonyms = "flame fire glow burn heat hot incandescent emission flash",
        .hard = {0, 1000},
        .soft = {0, 20},
        .step = 0.1,
        .tip = "Light that hot smoke gives off by itself, as fire.",
        .dirties = DirtyStage::Shade,
        .animates = Animates::Frame,
    }),
    row<&Glow::emissionCooling>({
        .key = "glow.emission_cooling",
        .formerly = "light.emission_cooling",
        .label = "Emission cooling",
        .synonyms = "fade glow flame fire smoky soot",
        .hard = {0, 100},
        .soft = {0, 10},
        .step = 0.05,
        .unit = Unit::PerSecond,
        .tip = "How fast the glow moves down its colours as smoke ages.",
        .dirties = DirtyStage::Shade,
        .animates = Animates::Frame,
    }),
    row<&Glow::hotCore>({
        .key = "glow.hot_core",
        .formerly = "light.hot_core",
        .label = "Hot core",
        .synonyms = "center inside white hot fire flame",
        .hard = kUnit,
        .step = 0.01,
        .tip = "How much cooler the rim glows than the inside: air cools what lies open to it, and fire shows in the "
               "gaps.",
        .dirties = DirtyStage::Shade,
        .animates = Animates::Frame,
    }),
    row<&Glow::flameOpacity>({
        .key = "glow.flame_opacity",
        .formerly = "light.flame_opacity",
        .label = "Flame opacity",
        .synonyms = "clear transparent soot additive fire",
        .hard = {0.01, 1},
        .step = 0.01,
        .tip = "How opaque smoke is while it glows, beside when it is cold. 1: it glows as lava does. 0.1: a clear "
               "flame that one sees into, from which soot forms as it cools.",
        .dirties = DirtyStage::Shade,
        .animates = Animates::Frame,
    }),
    row<&Glow::fireLight>({
        .key = "glow.fire_light",
        .formerly = "light.fire_light",
        .label = "Fire light",
        .synonyms = "flame glow bounce illuminate indirect lit light fire",
        .hard = {0, 100},
        .soft = {0, 4},
        .step = 0.05,
        .tip = "How much what glows lights the smoke around it. 1: as much as it gives off.",
        .dirties = DirtyStage::Shade,
        .animates = Animates::Frame,
    }),
    row<&Glow::emissionColour>({
        .key = "glow.emission_colour",
        .formerly = "light.emission_colour",
        .label = "Fire colours from",
        .synonyms = "blackbody color fire flame emission from",
        .tip = "Colours of your choice, or those of a body that glows by its temperature.",
        .choices = kEmissionColours,
        .dirties = DirtyStage::Shade,
        .animates = Animates::Frame,
    }),
    row<&Glow::temperature>({
        .key = "glow.temperature",
        .formerly = "light.temperature",
        .label = "Temperature",
        .synonyms = "heat kelvin hot cold fire blackbody red blue",
        .hard = {600, 20000},
        .soft = {900, 4000},
        .step = 10,
        .unit = Unit::Kelvin,
        .tip = "Temperature at birth: 1000 K glows red, 1900 K as a candle, 5800 K as the sun. As smoke cools, its "
               "glow turns red and fades.",
        .source = "Planck 1901; colour matching of Wyman et al. 2013",
        .visible = when("glow.emission_colour", EmissionColour::BlackBody),
        .dirties = DirtyStage::Shade,
        .animates = Animates::Frame,
    }),
    row<&Glow::emissionGradient>({
        .key = "glow.emission_colours",
        .formerly = "light.emission_colours",
        .label = "Emission colours",
        .synonyms = "color colors fire flame ramp gradient green blue magic",
        .hard = kColours,
        .soft = kUnit,
        .step = 0.01,
        .tip = "Colour of the glow from cold (left) to as hot as at birth (right).",
        .visible = when("glow.emission_colour", EmissionColour::Gradient),
        .dirties = DirtyStage::Shade,
    }),
};

} // namespace fumage
