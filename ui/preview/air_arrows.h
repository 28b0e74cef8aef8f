#pragma once

#include "ui/preview/picture.h"

#include "core/flow/field.h"

namespace fumage::ui {

/// The air on an upright slice through a place, as arrows a few cells apart: of the two slices along x and along z, the
/// one that faces the eye more.
/// @param forward way that the camera looks
/// About 0.1 ms.
[[nodiscard]] std::vector<AirArrow> findAirArrows(
    const AirField& field, const glm::vec3& through, const glm::vec3& forward);

} // namespace fumage::ui
