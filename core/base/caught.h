#pragma once

#include "core/base/result.h"

#include <system_error>

namespace fumage {

/// The code of what should not have been thrown at all. Nobody can react to it, so it has no name among the others.
inline constexpr auto kUnexpected = static_cast<ErrorCode>(-1);

/// What is said where the system does not start a thread, or does not do another thing that the standard library asks
/// of it.
/// @return OutOfMemory where it may do it another time, else PermissionDenied
[[nodiscard]] Error systemFailure(const std::system_error& cause);

/// What is being thrown, as an error that people can read. Only within a catch block, of any kind.
/// @return OutOfMemory where memory or threads cannot be had, what systemFailure() says, kUnexpected else
[[nodiscard]] Error caughtError();

} // namespace fumage
