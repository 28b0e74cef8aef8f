#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string_view>

namespace fumage {

/// The message of a system call that failed on a file.
/// @param number errno
/// @param otherwise code for what has none of its own
/// @param doing "read" or "write"
[[nodiscard]] Error fileError(int number, const std::filesystem::path& path, ErrorCode otherwise, std::string_view doing);

} // namespace fumage
