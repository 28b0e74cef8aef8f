#include "core/base/file_error.h"

#include <cerrno>
#include <cstring>
#include <string>

namespace fumage {

Error fileError(int number, const std::filesystem::path& path, ErrorCode otherwise, FileUse doing)
{
    const std::string place = path.string();
    const auto cannot = [doing](const Message& why) { return doing == FileUse::Read ? said("cannot read: %1", why) : said("cannot write: %1", why); };
    switch (number) {
    case ENOENT: return {ErrorCode::FileNotFound, cannot(said("there is no such file or folder")), place, said("Check the spelling of the path")};
    case EACCES:
    case EPERM: return {ErrorCode::PermissionDenied, cannot(said("permission denied")), place, said("Choose a place that you may use, or change its permissions")};
    case EROFS: return {ErrorCode::PermissionDenied, cannot(said("the disk is read-only")), place, said("Choose another disk")};
    case EISDIR: return {ErrorCode::NotAFile, cannot(said("it is a folder")), place, said("Name a file")};
    case ENOTDIR: return {ErrorCode::NotAFile, cannot(said("a part of the path is not a folder")), place, said("Check the path")};
    case ELOOP: return {ErrorCode::NotAFile, cannot(said("its symbolic links lead in a circle")), place, said("Remove the link or name another file")};
    case ENAMETOOLONG: return {ErrorCode::WriteFailed, cannot(said("the name is too long")), place, said("Choose a shorter name")};
    case ENOSPC:
    case EDQUOT: return {ErrorCode::DiskFull, cannot(said("the disk is full")), place, said("Free some space or choose another disk")};
    case EFBIG: return {ErrorCode::DiskFull, cannot(said("the file is larger than may be written here")), place, said("Choose another disk or a smaller size")};
    default: return {otherwise, cannot(std::string(std::strerror(number))), place, {}};
    }
}

} // namespace fumage
