#include "core/system/file_error.h"

#include "core/system/system_text.h"
#include "core/base/windows_api.h"

namespace fumage {

namespace {

constexpr DWORD kQuotaExceeded = 1295; ///< ERROR_DISK_QUOTA_EXCEEDED, which mingw-w64's headers lack

FileFailure failureOf(DWORD number)
{
    switch (number) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_NAME:
    case ERROR_BAD_NETPATH:
    case ERROR_BAD_NET_NAME:
    case ERROR_INVALID_DRIVE: return FileFailure::Missing;
    case ERROR_ACCESS_DENIED:
    case ERROR_PRIVILEGE_NOT_HELD: return FileFailure::Denied;
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
    case ERROR_USER_MAPPED_FILE: return FileFailure::InUse;
    case ERROR_WRITE_PROTECT: return FileFailure::ReadOnlyDisk;
    case ERROR_DIRECTORY: return FileFailure::NotAFolder;
    case ERROR_CANT_RESOLVE_FILENAME: return FileFailure::LinksInCircle;
    case ERROR_FILENAME_EXCED_RANGE:
    case ERROR_BUFFER_OVERFLOW: return FileFailure::NameTooLong;
    case ERROR_HANDLE_DISK_FULL:
    case ERROR_DISK_FULL:
    case kQuotaExceeded: return FileFailure::DiskFull;
    case ERROR_TOO_MANY_OPEN_FILES:
    case ERROR_NOT_ENOUGH_MEMORY:
    case ERROR_OUTOFMEMORY:
    case ERROR_NO_SYSTEM_RESOURCES:
    case ERROR_MAX_THRDS_REACHED:
    case ERROR_COMMITMENT_LIMIT: return FileFailure::Exhausted;
    case ERROR_FILE_TOO_LARGE: return FileFailure::TooLargeForDisk;
    default: return FileFailure::Other;
    }
}

} // namespace

Error fileError(int number, const std::filesystem::path& path, ErrorCode otherwise, FileUse doing)
{
    const auto error = static_cast<DWORD>(number);
    return fileError(failureOf(error), path, otherwise, doing, systemText(error));
}

} // namespace fumage
