#pragma once

#include "ui/pictures/picture.h"

namespace fumage::ui {

/// The ways of some particles of an effect over the last frames up to one, of those that are then alive.
/// Particles never act on one another, so that a few of them go where they would go among many.
/// About 2 ms.
[[nodiscard]] std::vector<Track> findTracks(const Effect& effect, int frame);

} // namespace fumage::ui
