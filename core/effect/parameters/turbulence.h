#pragma once

#include "core/effect/parameters/row.h"

namespace fumage {

template <>
inline constexpr Group<Turbulence> kGroup<Turbulence>{&Effect::turbulence, "turbulence", "Turbulence", Scope::Layer};

template <>
inline constexpr std::array kRows<Turbulence>{
    row<&Turbulence::strength>({
        .key = "turbulence.strength",
        .label = "Strength",
        .synonyms = "swirl chaos wild wavy turbulent messy calm curl noise rough smooth",
        .hard = {0, 1000},
        .soft = {0, 5},
        .step = 0.02,
        .unit = Unit::MetresPerSecond,
        .tip = "Speed of the swirls that carry the particles: its root mean square over space, all layers together.",
        .source = "Bridson et al. 2007, curl noise",
        .animates = Animates::Step,
    }),
    row<&Turbulence::scale>({
        .key = "turbulence.scale",
        .label = "Scale",
        .synonyms = "swirl size eddies big small coarse fine",
        .hard = {0.001, 1000},
        .soft = {0.1, 10},
        .step = 0.02,
        .unit = Unit::Metres,
        .scale = Scale::Log,
        .tip = "Size of the largest swirls at the height of the emitter.",
    }),
    row<&Turbulence::octaves>({
        .key = "turbulence.octaves",
        .label = "Octaves",
        .synonyms = "detail layers swirl fine",
        .hard = {1, kMaxTurbulenceOctaves},
        .soft = {1, 6},
        .step = 1,
        .tip = "Layers of ever smaller swirls; each costs the same time.",
    }),
    row<&Turbulence::roughness>({
        .key = "turbulence.roughness",
        .label = "Roughness",
        .synonyms = "detail gain persistence",
        .hard = kUnit,
        .step = 0.01,
        .tip = "Speed of each layer of swirls relative to the one before.",
        .animates = Animates::Step,
    }),
    row<&Turbulence::evolution>({
        .key = "turbulence.evolution",
        .label = "Evolution",
        .synonyms = "speed change animate fast slow",
        .hard = {0, 100},
        .soft = {0, 3},
        .step = 0.02,
        .unit = Unit::Hertz,
        .tip = "How often the largest swirls become others; smaller ones change faster.",
        .animates = Animates::Rate,
    }),
    row<&Turbulence::onset>({
        .key = "turbulence.onset",
        .label = "Fade-in time",
        .synonyms = "delay start calm onset",
        .hard = {0, 100},
        .soft = {0, 5},
        .step = 0.02,
        .unit = Unit::Seconds,
        .tip = "Age at which the swirls have their full strength; younger smoke is calmer.",
        .animates = Animates::Step,
    }),
    row<&Turbulence::growth>({
        .key = "turbulence.growth",
        .label = "Growth with height",
        .synonyms = "height taller high bigger larger",
        .hard = {0, 10},
        .soft = {0, 2},
        .step = 0.02,
        .unit = Unit::PerMetre,
        .tip = "How much larger the swirls are with each metre above the emitter, as in a plume that takes in air.",
        .animates = Animates::Step,
    }),
    row<&Turbulence::drift>({
        .key = "turbulence.drift",
        .label = "Drift",
        .synonyms = "rise move speed",
        .hard = {-1000, 1000},
        .soft = {0, 5},
        .step = 0.02,
        .unit = Unit::MetresPerSecond,
        .tip = "Speed at which the swirls rise along with the smoke, instead of standing still while it passes.",
        .animates = Animates::Rate,
    }),
    row<&Turbulence::lacunarity>({
        .key = "turbulence.lacunarity",
        .label = "Lacunarity",
        .synonyms = "frequency detail",
        .hard = {1, 8},
        .soft = {1.5, 3},
        .step = 0.05,
        .tip = "How many times smaller each layer of swirls is than the one before.",
    }),
    row<&Turbulence::detail>({
        .key = "turbulence.detail",
        .formerly = "air.detail",
        .label = "Detail",
        .synonyms = "wavelet turbulence noise subgrid sub-grid small swirls",
        .hard = {0, 10},
        .soft = {0, 2},
        .step = 0.02,
        .tip = "Swirls that are smaller than the cells of the air, as strong as the air around them is sheared. "
               "Octaves, roughness, evolution and drift of the turbulence say what they are like.",
        .source = "Kim, Th\u00fcrey, James, Gross 2008",
        .visible = when("air.enabled", true),
        .animates = Animates::Step,
    }),
};

} // namespace fumage
