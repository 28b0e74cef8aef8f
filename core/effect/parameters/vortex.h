#pragma once

#include "core/effect/parameters/row.h"

namespace fumage {

template <>
inline constexpr Group<Vortex> kGroup<Vortex>{&Effect::vortex, "vortex", "Vortex", Scope::Layer};

template <>
inline constexpr std::array kRows<Vortex>{
    row<&Vortex::strength>({
        .key = "vortex.strength",
        .label = "Strength",
        .synonyms = "tornado swirl twist spin whirl",
        .hard = {-1000, 1000},
        .soft = {-5, 5},
        .step = 0.05,
        .unit = Unit::MetresPerSecond,
        .tip = "Speed of the swirl at its radius. About an upright axis it turns from +X towards -Z; negative turns "
               "the other way.",
        .source = "Scully 1975, vortex profile",
        .dirties = DirtyStage::Air,
        .animates = Animates::Step,
    }),
    row<&Vortex::radius>({
        .key = "vortex.radius",
        .label = "Radius",
        .synonyms = "tornado width size",
        .hard = {0.001, 1000},
        .soft = {0.05, 5},
        .step = 0.01,
        .unit = Unit::Metres,
        .scale = Scale::Log,
        .tip = "Distance from the axis at which the swirl is fastest.",
        .dirties = DirtyStage::Air,
        .animates = Animates::Step,
    }),
    row<&Vortex::widening>({
        .key = "vortex.widening",
        .label = "Flare",
        .synonyms = "tornado funnel cone grow expand widening",
        .hard = {0, 10},
        .soft = {0, 1},
        .step = 0.01,
        .tip = "Metres that the radius grows with each metre along the axis, away from the emitter: a funnel.",
        .dirties = DirtyStage::Air,
        .animates = Animates::Step,
    }),
    row<&Vortex::axis>({
        .key = "vortex.axis",
        .label = "Axis",
        .synonyms = "tornado direction",
        .kind = Kind::Direction,
        .hard = kComponents,
        .step = 0.01,
        .tip = "Direction of the axis through the emitter about which the smoke swirls.",
        .dirties = DirtyStage::Air,
        .animates = Animates::Step,
    }),
};

} // namespace fumage
