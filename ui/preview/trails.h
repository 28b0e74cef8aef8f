#pragma once

#include "ui/preview/picture.h"

#include "core/simulation/air_cache.h"

namespace fumage::ui {

/// The ways of some particles of an effect over the last frames up to one, of those that are then alive.
/// Particles never act on one another, so that a few of them go where they would go among many.
/// @param shelf of baked air; about 2 ms where it has that of the effect
[[nodiscard]] std::vector<Trail> findTrails(
    const Scene& scene, std::size_t layer, int frame, const std::shared_ptr<AirCache>& shelf = nullptr);

} // namespace fumage::ui
