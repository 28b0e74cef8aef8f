#pragma once

#include "core/base/result.h"
#include "core/flow/air.h"
#include "core/simulation/air_source.h"
#include "core/simulation/air_step.h"

#include <vector>

namespace fumage {

/// Finds the layers that heat the air, or blow it up; where none does one of them stands for all. They are in the order
/// of their seeds, so that their order in a list means nothing: the box, the wind and what stirs the air go by the
/// first.
/// @param layers one or more
/// @param out gets their places in it, one or more; nothing is allocated where it has had as many before
void findFeedingLayers(SampledLayers layers, std::vector<std::size_t>& out);

/// The box of the air: that of the effect, or where air.fit is on, one as large as the smoke is expected to become.
/// Cells are cubes, as many along the longest side as air.resolution says; the box grows to whole cells.
///
/// What rises for a time t reaches z^4 = (1.9 F^(1/4) t^(3/4))^4 + (2.5 M^(1/4) t^(1/2))^4, F the buoyancy and M the
/// momentum that the source gives off a second, or 2.4 (B V)^(1/4) t^(1/2) for a burst of volume V; and becomes a
/// quarter as wide to each side. Heat lifts no longer than it lasts. Source: Turner, "Buoyancy Effects in Fluids",
/// 1973, of plumes, jets and thermals; the factors are rounded up.
/// Of several layers the box holds what is expected of each that feeds the air; a box of a given size stands at the one
/// of least seed, by whose seed the wind blows, too.
[[nodiscard]] AirGrid airGrid(SampledLayers layers);

/// The same of one layer.
[[nodiscard]] inline AirGrid airGrid(const SampledEffect& effect)
{
    return airGrid({&effect, 1});
}

/// What would keep the air of an effect from being computed: an emitter outside its box, an obstacle that fills it, a
/// box that no number holds, or a loop or a pre-warm that would be baked for very long before there is a picture.
/// Without air there is nothing.
/// @error OutOfRange, TooLarge
[[nodiscard]] Status checkAir(SampledLayers layers);

/// The same of one layer.
[[nodiscard]] inline Status checkAir(const SampledEffect& effect)
{
    return checkAir({&effect, 1});
}

/// The first step of the air: that of the layer that has risen for longest at frame 0, among those that feed it.
[[nodiscard]] std::int64_t firstAirStep(SampledLayers layers);

/// How a layer lies in its scene.
/// @param layer one of them, or the parent of one
[[nodiscard]] LayerClock layerClock(SampledLayers layers, const SampledEffect& layer);

/// Everything that the air of a scene depends on.
/// @param layers whose checkAir() found nothing
[[nodiscard]] AirPlan airPlan(SampledLayers layers);

/// The same of one layer.
[[nodiscard]] inline AirPlan airPlan(const SampledEffect& effect)
{
    return airPlan({&effect, 1});
}

/// The part of a layer that its air depends on, everything else at its default.
struct AirPart {
    Effect effect;
    Tracks tracks;
    friend bool operator==(const AirPart&, const AirPart&) = default;
};

/// The parts of the layers that their air depends on: equal for scenes that share their air.
[[nodiscard]] std::vector<AirPart> airParts(SampledLayers layers);

} // namespace fumage
