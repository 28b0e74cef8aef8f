#pragma once

#include "core/lighting/detail_field.h"
#include "core/lighting/light_field.h"

#include <array>

namespace fumage {

/// Multiplies a line of density by 1 + amount * (the noise there, as it is on average over what a cell can show), or 0
/// where that is negative, over the mean of that factor.
/// @param v,w the line, along u
/// @param amount above 0
void putDetailIntoLine(const DetailField& detail, float amount, int v, int w, LightGrid& grid);

/// How likely each octave is to be shown, see detail_lookup-inl.h.
/// @param at with the slope of the coordinates @param finest that can be shown, m
[[nodiscard]] std::array<float, DetailTexture::kLevels> octaveSharesAt(
    const DetailField& detail, const AdvectedPlace& at, float finest);

} // namespace fumage
