#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace fumage {

// What may change while smoke runs inside a game.

/// Whether an effect may become another.
/// @error OutOfRange where it differs in a parameter that is fixed (Parameter::live); without air, nothing of it is but
/// air.enabled
[[nodiscard]] Status checkChange(const Effect& now, const Effect& wanted);

/// Whether a scene may become another.
/// @error OutOfRange, as of an effect; or where it has other layers, other names, others that are muted, or others that
/// are born on another
[[nodiscard]] Status checkChange(const Scene& now, const Scene& wanted);

} // namespace fumage
