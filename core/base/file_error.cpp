#include "core/base/file_error.h"

#include <cerrno>
#include <cstring>
#include <string>

namespace fumage {

Error fileError(int number, const std::filesystem::path& path, ErrorCode otherwise, std::string_view doing)
{
    const std::string place = path.string();
    const std::string cannot = "cannot " + std::string(doing) + ": ";
    switch (number) {
    case ENOENT: return {ErrorCode::FileNotFound, cannot + "there is no such file or folder", place, "Check the spelling of the path"};
    case EACCES:
    case EPERM: return {ErrorCode::PermissionDenied, cannot + "permission denied", place, "Choose a place that you may use, or change its permissions"};
    case EROFS: return {ErrorCode::PermissionDenied, cannot + "the disk is read-only", place, "Choose another disk"};
    case EISDIR: return {ErrorCode::NotAFile, cannot + "it is a folder", place, "Name a file"};
    case ENOTDIR: return {ErrorCode::NotAFile, cannot + "a part of the path is not a folder", place, "Check the path"};
    case ELOOP: return {ErrorCode::NotAFile, cannot + "its symbolic links lead in a circle", place, "Remove the link or name another file"};
    case ENAMETOOLONG: return {ErrorCode::WriteFailed, cannot + "the name is too long", place, "Choose a shorter name"};
    case ENOSPC:
    case EDQUOT: return {ErrorCode::DiskFull, cannot + "the disk is full", place, "Free some space or choose another disk"};
    case EFBIG: return {ErrorCode::DiskFull, cannot + "the file is larger than may be written here", place, "Choose another disk or a smaller size"};
    default: return {otherwise, cannot + std::strerror(number), place, ""};
    }
}

} // namespace fumage
