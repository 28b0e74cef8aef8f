#pragma once

#include "core/effect/parameter.h"

#include <functional>

namespace fumage {

/// Whether a parameter may be changed at random.
using MayVary = std::function<bool(const Parameter&)>;

/// Says which parameters make the character of the smoke: not its seeds, camera, timeline, output, what costs time
/// (counts and resolutions) or switches.
[[nodiscard]] bool isCharacter(const Parameter& parameter);

/// A neighbour of an effect: each parameter that may vary moves by a random share of its soft range, normally
/// distributed.
/// @param amount standard deviation as a share of the soft range (of its logarithm on a log scale); 0 gives the effect
/// back
/// @param seed   another seed gives another neighbour; the same one the same bits
/// @param mayVary asked for every parameter; those without a meaning for "a little more" (switches, choices, seeds,
/// curves) never move The result is within the hard ranges. What is 0 is off and stays so, but for angles; parameters
/// that have no influence as the effect stands do not move.
[[nodiscard]] Effect vary(const Effect& effect, float amount, std::uint32_t seed, const MayVary& mayVary = isCharacter);

} // namespace fumage
