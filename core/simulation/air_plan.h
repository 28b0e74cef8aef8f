#pragma once

#include "core/base/result.h"
#include "core/flow/air.h"
#include "core/simulation/air_source.h"
#include "core/simulation/air_step.h"

namespace fumage {

/// The box of the air: that of the effect, or where air.fit is on, one as large as the smoke is expected to become.
/// Cells are cubes, as many along the longest side as air.resolution says; the box grows to whole cells.
///
/// What rises for a time t reaches z^4 = (1.9 F^(1/4) t^(3/4))^4 + (2.5 M^(1/4) t^(1/2))^4, F the buoyancy and M the
/// momentum that the source gives off a second, or 2.4 (B V)^(1/4) t^(1/2) for a burst of volume V; and becomes a
/// quarter as wide to each side. Heat lifts no longer than it lasts. Source: Turner, "Buoyancy Effects in Fluids",
/// 1973, of plumes, jets and thermals; the factors are rounded up.
[[nodiscard]] AirGrid airGrid(const SampledEffect& effect);

/// What would keep the air of an effect from being computed: an emitter outside its box, an obstacle that fills it, a
/// box that no number holds, or a loop or a pre-warm that would be baked for very long before there is a picture.
/// Without air there is nothing.
/// @error OutOfRange, TooLarge
[[nodiscard]] Status checkAir(const SampledEffect& effect);

/// Everything that the air of an effect depends on.
/// @param model of the same effect, whose checkAir() found nothing
[[nodiscard]] AirPlan airPlan(const SimulationModel& model);

/// The part of an effect that its air depends on, everything else at its default: equal for effects that share their
/// air.
[[nodiscard]] Effect airPart(const Effect& effect);

} // namespace fumage
