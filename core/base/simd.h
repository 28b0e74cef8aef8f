#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// Names of the instruction sets that this build has and this machine can run, best first: "avx512", "avx2",
/// "sse4", "neon"; last "baseline", which is what every machine of the architecture has (SSE2 on x86-64).
[[nodiscard]] std::vector<std::string> availableSimdTargets();

/// Runs all kernels on one instruction set from now on; an empty name goes back to the best one.
/// For tests and for measuring: every instruction set gives the same bits. Not thread-safe; call it before work starts.
/// @error UnknownName when this build or machine does not have it
[[nodiscard]] Status forceSimdTarget(std::string_view name);

} // namespace fumage
