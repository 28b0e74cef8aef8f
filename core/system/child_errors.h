#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace fumage {

// What ChildProcess says and keeps, whatever the system.

inline constexpr std::size_t kMaxChildSays = 4096; ///< bytes; the end of what a program says is what it stumbled over

/// Appends to what a program has said, and forgets the beginning of what is too long.
void keepEnd(std::string& said, std::string_view more);

/// @param number as fileError() takes it
/// @param reason in the system's words
[[nodiscard]] Error childNotStarted(int number, const std::string& program, const std::string& reason);
/// @param words what the program has said
[[nodiscard]] Error childFailed(const std::string& program, std::string_view words);
[[nodiscard]] Error childCancelled();

} // namespace fumage
