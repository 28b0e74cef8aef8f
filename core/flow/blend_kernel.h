#pragma once

#include "core/flow/field.h"

namespace fumage {

/// out = a + share (b - a), node by node, rounded to half floats as the fields of the solver are. The same bits on
/// every instruction set.
void blendFields(const AirField& a, const AirField& b, float share, AirField& out);

} // namespace fumage
