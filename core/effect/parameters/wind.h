#pragma once

#include "core/effect/parameters/row.h"

namespace fumage {

template <>
inline constexpr Group<Wind> kGroup<Wind>{&Effect::wind, "wind", "Wind", Scope::Scene};

template <>
inline constexpr std::array kRows<Wind>{
    row<&Wind::strength>({
        .key = "wind.strength",
        .formerly = "motion.wind",
        .label = "Wind strength",
        .synonyms = "blow breeze force air sideways drift lean fast strong",
        .hard = {0, 1000},
        .soft = {0, 5},
        .step = 0.01,
        .unit = Unit::MetresPerSecond2,
        .tip = "Acceleration Vw by the wind, level with the ground.",
        .source = "2012 model, eq. III and V",
        .dirties = DirtyStage::Air,
        .animates = Animates::Step,
    }),
    row<&Wind::angle>({
        .key = "wind.angle",
        .formerly = "motion.wind_angle",
        .label = "Wind angle",
        .synonyms = "direction blow heading",
        .hard = {-360, 360},
        .soft = {-180, 180},
        .step = 1,
        .unit = Unit::Degrees,
        .tip = "Angle \u03b8 of the wind in the horizontal X-Z plane; 0 blows along +X, 90 along +Z, "
               "against the sense of the rotation.",
        .source = "2012 model, eq. III and V",
        .dirties = DirtyStage::Air,
        .animates = Animates::Step,
        .essential = 6,
    }),
    row<&Wind::gust>({
        .key = "wind.gust",
        .formerly = "motion.gust",
        .label = "Gusts",
        .synonyms = "wind wander random breeze",
        .hard = kUnit,
        .step = 0.01,
        .tip = "How much the strength and direction of the wind wander.",
        .dirties = DirtyStage::Air,
        .animates = Animates::Step,
    }),
    row<&Wind::gustRate>({
        .key = "wind.gust_rate",
        .formerly = "motion.gust_rate",
        .label = "Gust rate",
        .synonyms = "wind frequency",
        .hard = {0, 100},
        .soft = {0, 5},
        .step = 0.05,
        .unit = Unit::Hertz,
        .tip = "How often the wind changes.",
        .dirties = DirtyStage::Air,
        .animates = Animates::Rate,
    }),
};

} // namespace fumage
