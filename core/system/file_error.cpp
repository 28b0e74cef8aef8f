#include "core/system/file_error.h"

namespace fumage {

Error fileError(FileFailure failure, const std::filesystem::path& path, ErrorCode otherwise, FileUse doing,
    const std::string& reason)
{
    const std::string place = path.string();
    const auto cannot = [doing](const Message& why) {
        return doing == FileUse::Read ? makeMessage("cannot read: %1", why) : makeMessage("cannot write: %1", why);
    };
    switch (failure) {
    case FileFailure::Missing:
        return {ErrorCode::FileNotFound, cannot(makeMessage("there is no such file or folder")), place,
            makeMessage("Check the spelling of the path")};
    case FileFailure::Denied:
        return {ErrorCode::PermissionDenied, cannot(makeMessage("permission denied")), place,
            makeMessage("Choose a place that you may use, or change its permissions")};
    case FileFailure::InUse:
        return {ErrorCode::PermissionDenied, cannot(makeMessage("another program is using it")), place,
            makeMessage("Close it there, or choose another name")};
    case FileFailure::ReadOnlyDisk:
        return {ErrorCode::PermissionDenied, cannot(makeMessage("the disk is read-only")), place,
            makeMessage("Choose another disk")};
    case FileFailure::IsFolder:
        return {ErrorCode::NotAFile, cannot(makeMessage("it is a folder")), place, makeMessage("Name a file")};
    case FileFailure::NotAFolder:
        return {ErrorCode::NotAFile, cannot(makeMessage("a part of the path is not a folder")), place,
            makeMessage("Check the path")};
    case FileFailure::LinksInCircle:
        return {ErrorCode::NotAFile, cannot(makeMessage("its symbolic links lead in a circle")), place,
            makeMessage("Remove the link or name another file")};
    case FileFailure::NameTooLong:
        return {ErrorCode::NotAFile, cannot(makeMessage("the name is too long")), place,
            makeMessage("Choose a shorter name")};
    case FileFailure::DiskFull:
        return {ErrorCode::DiskFull, cannot(makeMessage("the disk is full")), place,
            makeMessage("Free some space or choose another disk")};
    case FileFailure::TooLargeForDisk:
        return {ErrorCode::DiskFull, cannot(makeMessage("the file is larger than may be written here")), place,
            makeMessage("Choose another disk or a smaller size")};
    case FileFailure::NotAFile:
        return {
            ErrorCode::NotAFile, cannot(makeMessage("it is not a regular file")), place, makeMessage("Name a file")};
    case FileFailure::Unusable:
        return {ErrorCode::NotAFile, cannot(reason), place, makeMessage("Choose another name or another disk")};
    case FileFailure::Exhausted:
        return {ErrorCode::OutOfMemory,
            cannot(makeMessage("the system has no more files, processes or memory to give: %1", reason)), place,
            makeMessage("End other programs, raise its limits (ulimit -n, -u, -v), or try again later")};
    case FileFailure::Other: break;
    }
    return {otherwise, cannot(reason), place, {}};
}

} // namespace fumage
