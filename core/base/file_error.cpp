#include "core/base/file_error.h"

namespace fumage {

Error fileError(FileFailure failure, const std::filesystem::path& path, ErrorCode otherwise, FileUse doing, const std::string& reason)
{
    const std::string place = path.string();
    const auto cannot = [doing](const Message& why) { return doing == FileUse::Read ? said("cannot read: %1", why) : said("cannot write: %1", why); };
    switch (failure) {
    case FileFailure::Missing: return {ErrorCode::FileNotFound, cannot(said("there is no such file or folder")), place, said("Check the spelling of the path")};
    case FileFailure::Denied: return {ErrorCode::PermissionDenied, cannot(said("permission denied")), place, said("Choose a place that you may use, or change its permissions")};
    case FileFailure::InUse: return {ErrorCode::PermissionDenied, cannot(said("another program is using it")), place, said("Close it there, or choose another name")};
    case FileFailure::ReadOnlyDisk: return {ErrorCode::PermissionDenied, cannot(said("the disk is read-only")), place, said("Choose another disk")};
    case FileFailure::IsFolder: return {ErrorCode::NotAFile, cannot(said("it is a folder")), place, said("Name a file")};
    case FileFailure::NotAFolder: return {ErrorCode::NotAFile, cannot(said("a part of the path is not a folder")), place, said("Check the path")};
    case FileFailure::LinksInCircle: return {ErrorCode::NotAFile, cannot(said("its symbolic links lead in a circle")), place, said("Remove the link or name another file")};
    case FileFailure::NameTooLong:
        return {ErrorCode::NotAFile, cannot(said("the name is too long")), place, said("Choose a shorter name")};
    case FileFailure::DiskFull: return {ErrorCode::DiskFull, cannot(said("the disk is full")), place, said("Free some space or choose another disk")};
    case FileFailure::TooLargeForDisk: return {ErrorCode::DiskFull, cannot(said("the file is larger than may be written here")), place, said("Choose another disk or a smaller size")};
    case FileFailure::NotAFile: return {ErrorCode::NotAFile, cannot(said("it is not a regular file")), place, said("Name a file")};
    case FileFailure::Unusable:
        return {ErrorCode::NotAFile, cannot(reason), place, said("Choose another name or another disk")};
    case FileFailure::Exhausted:
        return {ErrorCode::OutOfMemory,
            cannot(said("the system has no more files, processes or memory to give: %1", reason)), place,
            said("End other programs, raise its limits (ulimit -n, -u, -v), or try again later")};
    case FileFailure::Other: break;
    }
    return {otherwise, cannot(reason), place, {}};
}

} // namespace fumage
