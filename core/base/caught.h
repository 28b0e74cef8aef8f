#pragma once

#include "core/base/result.h"

namespace fumage {

/// The code of what should not have been thrown at all. Nobody can react to it, so it has no name among the others.
inline constexpr auto kUnexpected = static_cast<ErrorCode>(-1);

/// What is being thrown, as an error that people can read. Only within a catch block, of any kind.
/// @return OutOfMemory where memory, threads or open files cannot be had, PermissionDenied where the system refuses
/// another thing that the standard library asks of it, kUnexpected else
[[nodiscard]] Error caughtError();

} // namespace fumage
