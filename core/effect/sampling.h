#pragma once

#include "core/effect/effect.h"

namespace fumage {

/// The effect with its output.quality worked into its numbers, and quality good: draft has a quarter of the particles, final eight times as
/// many (kMaxParticles at most), larger or smaller and denser or thinner so that the smoke covers as much and is as dense; shadows are coarser or finer.
/// Half of what the number changes goes into the size and half into the opacity: finer detail with less noise.
/// Applied to its own result it changes nothing.
[[nodiscard]] Effect sampled(const Effect& effect);

/// The same look with fewer particles, for previews: sizes grow so that the smoke covers as much.
/// @param most particles, 1 or more; the result is sampled()
[[nodiscard]] Effect thinned(const Effect& effect, int most);

} // namespace fumage
