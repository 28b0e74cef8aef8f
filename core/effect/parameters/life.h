#pragma once

#include "core/effect/parameters/row.h"

namespace fumage {

template <>
inline constexpr Group<Life> kGroup<Life>{&Effect::life, "life", "Life", Scope::Layer};

template <>
inline constexpr std::array kRows<Life>{
    row<&Life::fadeRate>({
        .key = "life.fade_rate",
        .label = "Fade rate",
        .synonyms = "fade vanish disappear dissolve fast slow lifetime life duration age lifespan out die",
        .hard = {0.001, 100},
        .soft = {0.005, 0.2},
        .step = 0.001,
        .unit = Unit::PerSecond,
        .scale = Scale::Log,
        .tip = "Alpha that a particle loses a second. Its life is the initial alpha divided by this.",
        .source = "2012 model, eq. XIII",
        .dirties = DirtyStage::Air,
        .essential = 4,
    }),
    row<&Life::initialAlpha>({
        .key = "life.initial_alpha",
        .label = "Initial alpha",
        .synonyms = "transparent transparency opacity density start",
        .hard = {0.001, 1},
        .soft = {0.01, 1},
        .step = 0.005,
        .scale = Scale::Log,
        .tip = "Alpha Ai of a particle at birth.",
        .source = "2012 model, eq. XIII (0.1 there)",
        .dirties = DirtyStage::Air,
    }),
    row<&Life::lifetimeVariance>({
        .key = "life.lifetime_variance",
        .label = "Lifetime variation",
        .synonyms = "life duration random variation lifespan lifetime variance",
        .hard = kUnit,
        .step = 0.01,
        .tip = "Lets particles die earlier, by up to this share of their life, so that the smoke thins out unevenly.",
    }),
    row<&Life::sizeCurve>({
        .key = "life.size",
        .label = "Size over life",
        .synonyms = "grow shrink scale expansion curve",
        .hard = kUnit,
        .step = 0.01,
        .tip = "Share of the particle's size, from birth to death.",
        .dirties = DirtyStage::Shade,
    }),
    row<&Life::alphaCurve>({
        .key = "life.alpha",
        .label = "Alpha over life",
        .synonyms = "fade in transparent transparency opacity curve",
        .hard = kUnit,
        .step = 0.01,
        .tip = "Multiplies the fading alpha, from birth to death.",
        .dirties = DirtyStage::Shade,
    }),
};

} // namespace fumage
