#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string>

namespace fumage {

/// What was tried with a file.
enum class FileUse {
    Read,
    Write
};

/// Why the system did not do it.
enum class FileFailure {
    Missing,
    Denied,
    InUse, ///< by another program, that lets nobody else at it
    ReadOnlyDisk,
    IsFolder,
    NotAFolder,
    LinksInCircle,
    NameTooLong,
    DiskFull,
    TooLargeForDisk,
    NotAFile, ///< a device, a pipe
    Unusable, ///< a name or a use that the file system does not know
    Exhausted, ///< the system has no more files, processes or memory to give at the time
    Other,
};

/// The message of a system call that failed on a file.
/// @param number errno; on Windows what GetLastError() says
/// @param otherwise code for what has none of its own
[[nodiscard]] Error fileError(int number, const std::filesystem::path& path, ErrorCode otherwise, FileUse doing);

/// @param reason in the system's words, for FileFailure::Other
[[nodiscard]] Error fileError(FileFailure failure, const std::filesystem::path& path, ErrorCode otherwise,
    FileUse doing, const std::string& reason = {});

} // namespace fumage
