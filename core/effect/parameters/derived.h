#pragma once

#include "core/effect/known_parameter.h"

namespace fumage {

/// A parameter that no effect holds: an artist's way to another one, which is what files keep.
struct DerivedParameter {
    Parameter row;
    std::string_view stored; ///< key of the parameter that is written instead
};

namespace derived {

inline Value lifetime(const Effect& effect)
{
    return effect.life.initialAlpha / effect.life.fadeRate;
}

/// The law of a particle's life, solved for the rate.
inline void setLifetime(Effect& effect, const Value& value)
{
    effect.life.fadeRate = effect.life.initialAlpha / std::get<float>(value);
}

} // namespace derived

inline constexpr std::array kDerivedParameters{
    DerivedParameter{
        {
            .key = "life.lifetime",
            .label = "Lifetime",
            .synonyms = "life duration lifespan age seconds long longer short shorter live last persist linger die",
            .kind = Kind::Float,
            .hard = {0.01, 1000},
            .soft = {0.2, 60},
            .step = 0.1,
            .unit = Unit::Seconds,
            .scale = Scale::Log,
            .tip = "Seconds from birth to death of a particle: the initial alpha divided by the fade rate. Setting it "
                   "sets the fade rate.",
            .source = "2012 model, eq. XIII",
            .get = &derived::lifetime,
            .set = &derived::setLifetime,
        },
        "life.fade_rate",
    },
};

} // namespace fumage
