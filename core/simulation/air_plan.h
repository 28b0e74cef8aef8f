#pragma once

#include "core/base/result.h"
#include "core/flow/air.h"
#include "core/simulation/schedule.h"

#include <array>
#include <span>

namespace fumage {

class Model;

/// The box of the air: that of the effect, or where air.fit is on, one as large as the smoke is expected to become. Cells are cubes, as many along the
/// longest side as air.resolution says; the box grows to whole cells.
///
/// What rises for a time t reaches z^4 = (1.9 F^(1/4) t^(3/4))^4 + (2.5 M^(1/4) t^(1/2))^4, F the buoyancy and M the momentum that the source gives off a
/// second, or 2.4 (B V)^(1/4) t^(1/2) for a burst of volume V; and becomes a quarter as wide to each side. Heat lifts no longer than it lasts.
/// Source: Turner, "Buoyancy Effects in Fluids", 1973, of plumes, jets and thermals; the factors are rounded up.
[[nodiscard]] AirGrid airGrid(const SampledEffect& effect);

/// What would keep the air of an effect from being computed: an emitter outside its box, an obstacle that fills it. Without air there is nothing.
/// @error OutOfRange
[[nodiscard]] Status checkAir(const SampledEffect& effect);

/// What moves the air of an effect from step number - 1 to step number.
/// @param grid that the air is on
/// @param acts whether the source gives anything off in this step
[[nodiscard]] AirStep airStep(const Model& model, const AirGrid& grid, std::int64_t number, bool acts);

/// Everything that the air of an effect depends on.
/// @param model of the same effect, whose checkAir() found nothing
[[nodiscard]] AirPlan airPlan(const Model& model);

/// The part of an effect that its air depends on, everything else at its default: equal for effects that share their air.
[[nodiscard]] Effect airPart(const Effect& effect);

/// How deep the source is along the emitter's normal, m: flat emitters have one too, or the air there would not be warmed. A ball has none beside its own.
[[nodiscard]] glm::vec3 sourceDepth(const Emitter& emitter, const AirGrid& grid);

/// The two directions in the emitter's plane, each over the distance from its middle to its rim, 1/m.
[[nodiscard]] std::array<glm::vec3, 2> sourceSides(const Emitter& emitter);

/// Velocity of what the emitter gives off, m/s.
[[nodiscard]] glm::vec3 sourceVelocity(const Emitter& emitter);

} // namespace fumage
