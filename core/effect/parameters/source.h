#pragma once

#include "core/effect/parameters/row.h"

namespace fumage {

template <>
inline constexpr Group<Source> kGroup<Source>{&Effect::source, "source", "Source", Scope::Layer};

template <>
inline constexpr std::array kRows<Source>{
    row<&Source::feeds>({
        .key = "source.feeds",
        .since = 2,
        .label = "Feeds the air",
        .synonyms = "heat push drive passive emits heats influence follows",
        .tip = "Whether the emitter heats, pushes and stirs the air. Without it its particles only follow the air that "
               "others move: embers, dust, debris.",
        .visible = when("air.enabled", true),
        .dirties = DirtyStage::Air,
        .varies = false,
    }),
    row<&Source::raggedness>({
        .key = "source.raggedness",
        .formerly = "air.raggedness",
        .label = "Source noise",
        .synonyms = "irregular noise source asymmetry breathe flicker raggedness",
        .hard = kUnit,
        .step = 0.01,
        .tip = "How far the rim of the source wanders, and how unevenly it blows. Without it smoke rises as a column "
               "of one width.",
        .visible = when("air.enabled", true),
        .dirties = DirtyStage::Air,
        .animates = Animates::Step,
    }),
    row<&Source::unevenness>({
        .key = "source.unevenness",
        .formerly = "air.unevenness",
        .label = "Heat noise",
        .synonyms = "billows cauliflower hot spots noise source asymmetry heterogeneous bald uneven heat",
        .hard = {0, 3},
        .soft = {0, 1.5},
        .step = 0.02,
        .tip = "How much the heat of the source differs from place to place, as a share of it. What is hotter rises "
               "ahead of the rest: billows on billows. Without it a cap is bald.",
        .visible = when("air.enabled", true),
        .dirties = DirtyStage::Air,
        .animates = Animates::Step,
    }),
    row<&Source::expansion>({
        .key = "source.expansion",
        .formerly = "air.expansion",
        .label = "Expansion",
        .synonyms = "explosion blast pressure burst divergence big",
        .hard = {0, 1000},
        .soft = {0, 30},
        .step = 0.5,
        .unit = Unit::PerSecond,
        .tip = "Volume that the source adds to the air, as a multiple of its own each second, as long as it emits: a "
               "burst blows up a ball.",
        .visible = when("air.enabled", true),
        .dirties = DirtyStage::Air,
        .animates = Animates::Step,
    }),
    row<&Source::surge>({
        .key = "source.surge",
        .since = 2,
        .label = "Surge",
        .synonyms = "puff pulse breathe flicker lull rhythm uneven speed burst pump throb",
        .hard = kUnit,
        .step = 0.02,
        .tip = "How much a steady source comes in puffs: its heat, speed and expansion swell and fall, each puff as "
               "strong as chance has it; the mean stays. 0: even.",
        .visible = when("air.enabled", true),
        .dirties = DirtyStage::Air,
        .animates = Animates::Step,
    }),
    row<&Source::surgeRate>({
        .key = "source.surge_rate",
        .since = 2,
        .label = "Surge rate",
        .synonyms = "puff pulse frequency flicker rhythm puffing",
        .hard = {0.01, 30},
        .soft = {0.1, 10},
        .step = 0.05,
        .unit = Unit::Hertz,
        .scale = Scale::Log,
        .tip = "Puffs a second; in a loop a whole number of them. A fire puffs at about 1.5 Hz over the root of its "
               "width in metres.",
        .source = "Cetegen and Ahmed 1993",
        .visible = when("air.enabled", true),
        .dirties = DirtyStage::Air,
        .animates = Animates::Rate,
    }),
};

} // namespace fumage
