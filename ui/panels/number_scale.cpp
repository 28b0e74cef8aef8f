#include "ui/panels/number_scale.h"

#include <algorithm>
#include <cmath>

namespace fumage::ui {

NumberScale NumberScale::of(const Parameter& parameter)
{
    NumberScale scale;
    scale.hard = parameter.hard;
    scale.soft = parameter.soft;
    scale.step = parameter.step > 0.0 ? parameter.step : 1.0;
    scale.logarithmic = parameter.scale == Scale::Log;
    scale.whole = parameter.kind == Kind::Int || parameter.kind == Kind::Seed;
    scale.unit = parameter.unit;
    return scale;
}

double NumberScale::position(double value) const
{
    const double inside = std::clamp(value, soft.low, soft.high);
    if (logarithmic) {
        return std::log(inside / soft.low) / std::log(soft.high / soft.low);
    }
    return (inside - soft.low) / (soft.high - soft.low);
}

double NumberScale::valueAt(double position) const
{
    if (logarithmic) {
        return settled(soft.low * std::pow(soft.high / soft.low, position));
    }
    return settled(std::round((soft.low + (soft.high - soft.low) * position) / step) * step);
}

double NumberScale::stepped(double value, double steps) const
{
    if (logarithmic) {
        constexpr double kPartOfValue = 0.02;
        const double moved = value * std::exp(steps * kPartOfValue);
        // Small whole numbers would never get to the next one.
        return settled(whole && std::abs(moved - value) < 1.0 ? value + std::copysign(1.0, steps) : moved);
    }
    return settled(value + steps * step);
}

double NumberScale::settled(double value) const
{
    const double inside = std::clamp(value, hard.low, hard.high);
    if (whole) {
        return std::round(inside);
    }
    if (logarithmic) {
        constexpr double kDigits = 1000.0; // of the value's magnitude
        const double magnitude = std::pow(10.0, std::floor(std::log10(std::max(std::abs(inside), 1e-9))));
        return std::clamp(std::round(inside / magnitude * kDigits) / kDigits * magnitude, hard.low, hard.high);
    }
    constexpr double kPartsOfStep = 100.0;
    return std::clamp(std::round(inside / step * kPartsOfStep) / kPartsOfStep * step, hard.low, hard.high);
}

} // namespace fumage::ui
