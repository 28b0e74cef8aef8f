#pragma once

#include "core/effect/gradient.h"

#include <QString>

#include <span>

namespace fumage::ui {

/// A gradient that many effects begin with.
struct GradientPreset {
    const char* name; ///< key for tr()
    Gradient gradient;
};

[[nodiscard]] std::span<const GradientPreset> gradientPresets();
[[nodiscard]] QString nameOf(const GradientPreset& preset);

/// All colours with their hues turned, each as bright and as strong as before; grey stays grey.
[[nodiscard]] Gradient hueShifted(const Gradient& gradient, double degrees);

/// The last colour first.
[[nodiscard]] Gradient reversed(const Gradient& gradient);

} // namespace fumage::ui
