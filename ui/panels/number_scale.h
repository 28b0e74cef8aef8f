#pragma once

#include "core/effect/parameter.h"

namespace fumage::ui {

/// How a number moves under the hand: its range, step and scale.
struct NumberScale {
    Range hard;
    Range soft;
    double step = 0.01;
    bool logarithmic = false;
    bool whole = false;
    Unit unit = Unit::None;

    /// Of the components where the parameter is a vector.
    [[nodiscard]] static NumberScale of(const Parameter& parameter);

    /// Place of a value on a slider over the soft range, in [0, 1].
    [[nodiscard]] double position(double value) const;
    [[nodiscard]] double valueAt(double position) const;

    /// A value moved by some steps: by so many times the step, or on a logarithmic scale by so many parts of the value.
    [[nodiscard]] double stepped(double value, double steps) const;

    /// Within the hard range; whole where it must be; else rounded to a hundredth of the step, so that no digits appear
    /// that nobody asked for.
    [[nodiscard]] double settled(double value) const;
};

} // namespace fumage::ui
