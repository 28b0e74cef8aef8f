#pragma once

#include "core/effect/parameters/row.h"

namespace fumage {

inline constexpr std::array<std::string_view, 2> kEmissionColours{"gradient", "black-body"};

template <>
inline constexpr Group<Light> kGroup<Light>{&Effect::light, "light", "Light"};

template <>
inline constexpr std::array kRows<Light>{
    row<&Light::direction>({
        .key = "light.direction",
        .label = "Direction",
        .kind = Kind::Direction,
        .hard = kComponents,
        .step = 0.01,
        .tip = "The direction in which the light of the sun travels.",
        .stage = Stage::Shade,
    }),
    row<&Light::intensity>({
        .key = "light.intensity",
        .label = "Intensity",
        .hard = {0, 1000},
        .soft = {0, 10},
        .step = 0.05,
        .tip = "Strength of the sun.",
        .stage = Stage::Shade,
    }),
    row<&Light::shadow>({
        .key = "light.shadow",
        .label = "Shadow",
        .hard = {0, 100},
        .soft = {0, 4},
        .step = 0.02,
        .tip = "How much light is lost on the way through the smoke.",
        .stage = Stage::Shade,
    }),
    row<&Light::scattering>({
        .key = "light.scattering",
        .label = "Scattering",
        .hard = {0, 0.95},
        .step = 0.01,
        .tip = "Light that is scattered many times and reaches deep into dense smoke, so that it is not black.",
        .source = "Wrenninge et al. 2013, octaves of scattering",
        .stage = Stage::Shade,
    }),
    row<&Light::anisotropy>({
        .key = "light.anisotropy",
        .label = "Anisotropy",
        .hard = {-0.95, 0.95},
        .soft = {-0.9, 0.9},
        .step = 0.01,
        .tip = "More than 0: smoke glows when it stands before the sun. Less: it is brighter with the sun behind the "
               "camera.",
        .source = "Henyey and Greenstein 1941",
        .stage = Stage::Shade,
    }),
    row<&Light::ambient>({
        .key = "light.ambient",
        .label = "Ambient",
        .hard = {0, 1000},
        .soft = {0, 4},
        .step = 0.02,
        .tip = "Strength of the light from sky and ground.",
        .stage = Stage::Shade,
    }),
    row<&Light::colour>({
        .key = "light.colour",
        .label = "Colour",
        .kind = Kind::Colour,
        .hard = kColours,
        .soft = kUnit,
        .step = 0.01,
        .tip = "Colour of the sun.",
        .stage = Stage::Shade,
    }),
    row<&Light::sky>({
        .key = "light.sky",
        .label = "Sky",
        .kind = Kind::Colour,
        .hard = kColours,
        .soft = kUnit,
        .step = 0.01,
        .tip = "Colour of the light from above.",
        .stage = Stage::Shade,
    }),
    row<&Light::ground>({
        .key = "light.ground",
        .label = "Ground",
        .kind = Kind::Colour,
        .hard = kColours,
        .soft = kUnit,
        .step = 0.01,
        .tip = "Colour of the light from below.",
        .stage = Stage::Shade,
    }),
    row<&Light::occlusion>({
        .key = "light.occlusion",
        .label = "Occlusion",
        .hard = {0, 100},
        .soft = {0, 4},
        .step = 0.02,
        .tip = "How much the light from sky and ground is lost inside dense smoke.",
        .stage = Stage::Shade,
    }),
    row<&Light::emission>({
        .key = "light.emission",
        .label = "Emission",
        .hard = {0, 1000},
        .soft = {0, 20},
        .step = 0.1,
        .tip = "Light that hot smoke gives off by itself, as fire.",
        .stage = Stage::Shade,
    }),
    row<&Light::emissionCooling>({
        .key = "light.emission_cooling",
        .label = "Emission cooling",
        .hard = {0, 100},
        .soft = {0, 10},
        .step = 0.05,
        .unit = Unit::PerSecond,
        .tip = "How fast the glow moves down its colours as smoke ages.",
        .stage = Stage::Shade,
    }),
    row<&Light::hotCore>({
        .key = "light.hot_core",
        .label = "Hot core",
        .hard = kUnit,
        .step = 0.01,
        .tip = "How much cooler the rim glows than the inside: air cools what lies open to it, and fire shows in the "
               "gaps.",
        .stage = Stage::Shade,
    }),
    row<&Light::emissionColour>({
        .key = "light.emission_colour",
        .label = "Emission from",
        .tip = "Colours of your choice, or those of a body that glows by its temperature.",
        .choices = kEmissionColours,
        .stage = Stage::Shade,
    }),
    row<&Light::temperature>({
        .key = "light.temperature",
        .label = "Temperature",
        .hard = {600, 20000},
        .soft = {900, 4000},
        .step = 10,
        .unit = Unit::Kelvin,
        .tip = "Temperature at birth: 1000 K glows red, 1900 K as a candle, 5800 K as the sun. As smoke cools, its "
               "glow turns red and fades.",
        .source = "Planck 1901; colour matching of Wyman et al. 2013",
        .visible = when("light.emission_colour", EmissionColour::BlackBody),
        .stage = Stage::Shade,
    }),
    row<&Light::emissionGradient>({
        .key = "light.emission_colours",
        .label = "Emission colours",
        .hard = kColours,
        .soft = kUnit,
        .step = 0.01,
        .tip = "Colour of the glow from cold (left) to as hot as at birth (right).",
        .visible = when("light.emission_colour", EmissionColour::Gradient),
        .stage = Stage::Shade,
    }),
    row<&Light::resolution>({
        .key = "light.resolution",
        .label = "Resolution",
        .hard = {8, kMaxLightResolution},
        .soft = {32, 128},
        .step = 8,
        .tip = "Cells of the density grid along the longest side of the cloud.",
        .stage = Stage::Shade,
    }),
};

} // namespace fumage
