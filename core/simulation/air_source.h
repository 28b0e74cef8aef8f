#pragma once

#include "core/effect/effect.h"
#include "core/flow/grid.h"

#include <array>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace fumage {

// The emitter as the air sees it.

/// Radius of the source, seen from along its normal, m: of a rectangle, that of a disc of the same area.
[[nodiscard]] float sourceRadius(const Emitter& emitter);

/// Half its edges, or its radius twice, m.
[[nodiscard]] glm::vec2 sourceReach(const Emitter& emitter);

/// How much of its speed what leaves the emitter has along its normal in the mean: (1 + cos(spread)) / 2 of a cone that
/// is filled evenly.
[[nodiscard]] float alongNormal(const Emitter& emitter);

/// How deep the source is along the emitter's normal, m: flat emitters have one too, or the air there would not be
/// warmed. A ball has none beside its own.
[[nodiscard]] glm::vec3 sourceDepth(const Emitter& emitter, const AirGrid& grid);

/// The two directions in the emitter's plane, each over the distance from its middle to its rim, 1/m.
[[nodiscard]] std::array<glm::vec3, 2> sourceSides(const Emitter& emitter);

/// Mean velocity of what the emitter gives off, which is that of the air in it, m/s: the wider its cone is the slower,
/// and a full one has none.
[[nodiscard]] glm::vec3 sourceVelocity(const Emitter& emitter);

} // namespace fumage
