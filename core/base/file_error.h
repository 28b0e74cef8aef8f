#pragma once

#include "core/base/result.h"

#include <filesystem>

namespace fumage {

/// What was tried with a file.
enum class FileUse {
    Read,
    Write
};

/// The message of a system call that failed on a file.
/// @param number errno
/// @param otherwise code for what has none of its own
[[nodiscard]] Error fileError(int number, const std::filesystem::path& path, ErrorCode otherwise, FileUse doing);

} // namespace fumage
